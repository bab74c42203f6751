// The same columns and the same hits as the sequential search of stride 1, without looking at most
// of them: a cell of the image whose surface is all farther than the ray is left at once, and so is
// one whose surface all hides a ray that is behind it already. One fetch tells of the cells of three
// sizes about a place.

const vec3 CELL_SIDES = vec3(CELL, CELL * CELLS_MERGED, CELL * CELLS_MERGED * CELLS_MERGED);

// Nearest windowZ of the smallest, middle and large cell about a place, and the farthest of the
// smallest.
vec4 pyramidCell(Capture capture, vec2 window)
{
    COUNT_FETCH
    return texelFetch(capture.cells, ivec2(window) / CELL, 0);
}

// How fast a ray crosses cells.
struct Pace
{
    vec2 ahead;           // 1 where it moves toward larger places, else 0
    vec2 columnsPerPixel; // signed, finite
    float columnsPerZ;    // [1 / windowZ] > 0; endless where the ray comes nearer
};

Pace paceOf(vec3 perColumn)
{
    // A ray that moves by less stays in its column or row, as far as any image reaches.
    vec2 moved = mix(perColumn.xy, vec2(1e-6), lessThan(abs(perColumn.xy), vec2(1e-6)));
    Pace pace;
    pace.ahead = vec2(greaterThan(moved, vec2(0.0)));
    pace.columnsPerPixel = 1.0 / moved;
    pace.columnsPerZ = perColumn.z > 0.0 ? 1.0 / perColumn.z : 1e30;
    return pace;
}

// How many columns, from one at a place on, lie within the cell about it.
//   window  of the ray at the first column [pixels]
float columnsWithin(float side, vec2 window, Pace pace)
{
    vec2 border = (floor(window / side) + pace.ahead) * side;
    vec2 columns = (border - window) * pace.columnsPerPixel;
    // Rounded up, but not where a rounding error would take in one column more.
    return max(floor(min(columns.x, columns.y) + 0.999), 1.0);
}

// How many columns of a cell the ray passes without reaching what is nearest in it.
//   room  how far that is behind the ray at the first of them [windowZ]
float columnsInFront(float side, vec2 window, float room, Pace pace)
{
    return clamp(ceil(room * pace.columnsPerZ), 0.0, columnsWithin(side, window, pace));
}

TraceResult searchImage(Capture capture, ImageRay ray)
{
    Columns columns = columnsOf(capture, ray, 1.0);
    float perColumnZ = columns.step * (ray.end.z - ray.start.z);
    Pace pace = paceOf(columns.step * (ray.end - ray.start));

    Trail trail = trailOf(ray, columns);
    int i = 0;
    while (i < columns.count && !trail.meeting.hit)
    {
        bool reached = false;
        while (i < columns.count && !reached)
        {
            vec3 window = windowAt(ray, columnAt(columns, i));
            vec4 cell = pyramidCell(capture, window.xy);
            // Background is never reached.
            vec3 room = mix(cell.xyz - window.z - trail.lookAheadZ, vec3(1.0),
                            greaterThanEqual(cell.xyz, vec3(1.0)));
            float within = columnsWithin(CELL_SIDES.x, window.xy, pace);
            float free = max(clamp(ceil(room.x * pace.columnsPerZ), 0.0, within),
                             max(columnsInFront(CELL_SIDES.y, window.xy, room.y, pace),
                                 columnsInFront(CELL_SIDES.z, window.xy, room.z, pace)));
            trail.inFront = trail.inFront || free > 0.0;

            float leastZ = window.z + min(within * perColumnZ, 0.0) + trail.lookAheadZ;
            bool staysBehind = !trail.inFront && cell.a < 1.0 && leastZ >= cell.a;
            int last = min(i + int(within), columns.count);
            i += int(staysBehind ? within : free);
            while (i < last && !reached)
                reached = reaches(capture, ray, columns, i++, trail);
        }
        if (reached) meet(capture, ray, columns, i - 1, trail);
    }
    return resultOf(capture, ray, columns, trail);
}
