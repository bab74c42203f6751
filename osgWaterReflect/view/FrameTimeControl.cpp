#include "FrameTimeControl.h"

#include <algorithm>
#include <numeric>

using namespace osgWaterReflect;

namespace
{

// Mean of the middle half. It takes as many outliers as a quarter of the window, as hitches are;
// and where a display's refresh rounds each interval up, it still tells how many missed theirs, of
// which a median knows nothing up to half of them.
double typicalOf(std::vector<double>& intervals)
{
    std::sort(intervals.begin(), intervals.end());
    const auto quarter = static_cast<std::ptrdiff_t>(intervals.size() / 4);
    const auto first = intervals.begin() + quarter;
    const auto last = intervals.end() - quarter;
    return std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
}

} // namespace

FrameTimeControl::FrameTimeControl(int numSteps) :
    _times(static_cast<std::size_t>(std::max(numSteps, 1)), 0.0)
{
}

void FrameTimeControl::frame(double now, double target)
{
    const double interval = now - _previous;
    if (interval <= 0.0) return;
    _previous = now;
    if (target != _target)
    {
        _target = target;
        forgetWaits();
    }
    if (interval > PAUSE)
    {
        startWindow();
        _framesInFlight = FRAMES_IN_FLIGHT; // and those that load what comes into view
    }
    else if (_framesInFlight > 0)
        --_framesInFlight;
    else
    {
        _window.push_back(interval);
        _windowTime += interval;
    }
    if (_window.size() < WINDOW_FRAMES || _windowTime < WINDOW_TIME) return;
    judge(now, typicalOf(_window));
    startWindow();
}

void FrameTimeControl::startWindow()
{
    _window.clear();
    _windowTime = 0.0;
}

void FrameTimeControl::forgetWaits()
{
    _wait = FIRST_WAIT;
    _trust = FIRST_TRUST;
}

void FrameTimeControl::judge(double now, double time)
{
    learn(time);
    const double since = now - _changed;
    const bool held = _change != Change::DOWN && since >= HOLD;
    if (held || time * CLEAR_CHANGE < _lowest) forgetWaits();
    const bool risen = time > CLEAR_CHANGE * _lowest;
    _lowest = std::min(_lowest, time);

    const bool over = isOver(time);
    if (over && !gainsBelow(_step) && (risen || since >= MAX_WAIT)) doubtFaster();
    if (over && gainsBelow(_step)) return change(now, Change::DOWN);
    if (_step == 0) return;
    const bool good = over ? !gainsBelow(_step - 1) : fits(_times[_step - 1]);
    if (since >= (good || _hiddenRoom ? _wait : std::max(_wait, _trust)))
        change(now, good ? Change::UP : Change::UP_AGAINST_FORECAST);
}

// What is known of the other steps is how their times compare with this step's, as measured from
// one window to the next when they were last left for each other.
void FrameTimeControl::learn(double time)
{
    double& expected = _times[_step];
    if (_arrived)
    {
        _hiddenRoom = _change != Change::DOWN && time < (1.0 - TOLERANCE) * expected;
        _lowest = expected > 0.0 ? std::min(expected, time) : time;
        expected = time;
        _arrived = false;
        return;
    }
    const double load = time / expected;
    for (double& each : _times)
        each *= load;
}

// Unknown again, so worth a try.
void FrameTimeControl::doubtFaster()
{
    std::fill(_times.begin() + static_cast<std::ptrdiff_t>(_step) + 1, _times.end(), 0.0);
}

void FrameTimeControl::change(double now, Change how)
{
    if (how == Change::DOWN && _change != Change::DOWN && now - _changed < HOLD)
    {
        double& failed = _change == Change::UP ? _wait : _trust;
        failed = std::min(2.0 * failed, MAX_WAIT);
    }
    how == Change::DOWN ? ++_step : --_step;
    _change = how;
    _changed = now;
    _arrived = true;
    _framesInFlight = FRAMES_IN_FLIGHT;
}

// Whether a faster step is unknown, fits, or is faster by a share worth having.
bool FrameTimeControl::gainsBelow(std::size_t step) const
{
    const double enough = std::max(_target, (1.0 - LEAST_GAIN) * _times[step]);
    return std::any_of(_times.begin() + static_cast<std::ptrdiff_t>(step) + 1, _times.end(),
                       [&](double time) { return time <= enough; });
}
