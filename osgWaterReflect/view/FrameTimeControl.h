#ifndef OSGWATERREFLECT_VIEW_FRAMETIMECONTROL_H
#define OSGWATERREFLECT_VIEW_FRAMETIMECONTROL_H

#include <cstddef>
#include <limits>
#include <vector>

namespace osgWaterReflect
{

/// Which step of accuracy a view can afford within a target of time a frame: step 0 is as accurate
/// as was asked for, each further one is faster.
///
/// Frames are judged a window at a time, by their time in the mean of the window's middle half.
/// - Over the target: one step down, unless no faster step is known to fit or to gain anything.
///   Then back up, to where more accuracy would cost time; the faster steps are tried again after
///   MAX_WAIT, or when the load has clearly risen.
/// - Within it: one step up where that is forecast to fit, from how the steps' times compared when
///   they were last left for each other.
/// - No step up comes sooner than a wait after the last change. A forecast that speaks against it
///   is believed for a time only, the trust: other things change what a step costs, and a display
///   that frames wait for hides how much room is left.
/// - Down again before HOLD is over: the wait or trust that led up doubles. Both start anew when a
///   step up holds, when the load has clearly fallen, and with another target.
///
/// So the k-th step up that fails under an unchanging load comes FIRST_WAIT * (2^k - 1) after the
/// first change or later. A load at the limit of one step makes fewer than one change a minute in
/// the long run; one that moves about it, as unfavourably as can be but for clear changes, fewer
/// than four.
class FrameTimeControl
{
public:
    explicit FrameTimeControl(int numSteps);

    /// To be called once a frame.
    ///   now     [s] of a monotonic clock, when the frame begins
    ///   target  [s] > 0
    void frame(double now, double target);

    int step() const { return static_cast<int>(_step); }

    /// [1] of the target, to either side: over it from above, room for a step up from below. Noise
    /// of 10 % a frame leaves the time of the shortest window a standard error of 2.8 %, of one at
    /// 60 Hz 2.0 %: five of them lie between going down and up.
    static constexpr double TOLERANCE = 0.05;

    /// [1] of a step's time, less than which is no gain: three standard errors of the ratio of two
    /// windows at 60 Hz, 2.8 %, and a little.
    static constexpr double LEAST_GAIN = 0.1;

    /// [1] Ratio of two times at one step that only another load explains: a fall by a third.
    static constexpr double CLEAR_CHANGE = 1.5;

    /// [s] Half a second at least, so that a burst of slow frames that nobody would call slow does
    /// not decide; 15 frames at least, of which 3 stragglers at either end do not count.
    static constexpr double WINDOW_TIME = 0.5;
    static constexpr int WINDOW_FRAMES = 15;

    /// Frames after a change that were in flight already: one is drawn while the next is culled,
    /// and drivers queue two more.
    static constexpr int FRAMES_IN_FLIGHT = 3;

    /// [s] A longer interval is a pause, not a frame: nobody steers by one picture a second.
    static constexpr double PAUSE = 1.0;

    /// [s] What has just been seen to change is left alone for as long as an eye rests on it.
    static constexpr double FIRST_WAIT = 4.0;

    /// [s] A failed try shows a second of slow frames: in a minute no more than that.
    static constexpr double FIRST_TRUST = 64.0;

    /// [s] Of wait and trust. Four minutes: how late it may be noticed that a load has gone.
    static constexpr double MAX_WAIT = 256.0;

    /// [s] As long as trust: what was tried and kept that long was right.
    static constexpr double HOLD = 64.0;

private:
    enum class Change
    {
        DOWN,
        UP, // as was forecast to fit
        UP_AGAINST_FORECAST
    };

    void startWindow();
    void forgetWaits();
    void judge(double now, double time);
    void learn(double time);
    void doubtFaster();
    void change(double now, Change how);
    bool fits(double time) const { return time <= (1.0 - TOLERANCE) * _target; }
    bool isOver(double time) const { return time > (1.0 + TOLERANCE) * _target; }
    bool gainsBelow(std::size_t step) const;

    std::size_t _step = 0;
    double _target = 0.0;                                        // [s]
    double _previous = -std::numeric_limits<double>::infinity(); // [s] the last frame's beginning

    int _framesInFlight = 0;
    std::vector<double> _window; // [s]
    double _windowTime = 0.0;    // [s]

    std::vector<double> _times; // [s] expected of each step under the present load; 0 unknown
    bool _arrived = true;       // at this step, its time not yet measured
    double _lowest = 0.0;       // [s] measured at this step, or expected of it on arrival
    bool _hiddenRoom = false;   // the step up cost clearly less than was forecast

    Change _change = Change::DOWN;
    double _changed = 0.0;       // [s]
    double _wait = FIRST_WAIT;   // [s] before a step up that is forecast to fit
    double _trust = FIRST_TRUST; // [s] in a forecast that it will not
};

} // namespace osgWaterReflect

#endif
