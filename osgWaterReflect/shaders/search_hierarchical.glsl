// The same columns and the same hits as the sequential search of stride 1, without looking at most
// of them: a cell of the image whose surface is all farther than the ray is left at once, and so is
// one whose surface all hides a ray that is behind it already. One fetch tells of the cells of three
// sizes about a place.

const vec3 CELL_SIDES = vec3(CELL, CELL * CELLS_MERGED, CELL * CELLS_MERGED * CELLS_MERGED);

// Nearest windowZ of the smallest, middle and large cell about a place, and the farthest of the
// smallest.
vec4 pyramidCell(Capture capture, vec2 window)
{
    COUNT_DEPTH_FETCH
    return texelFetch(capture.cells, ivec2(window) / CELL, 0);
}

// How many columns, from one at a place on, lie within the cell about it.
//   window     of the ray at the first column [pixels]
//   perColumn  how the place moves from column to column [pixels], no component 0
float columnsWithin(float side, vec2 window, vec2 perColumn)
{
    vec2 low = floor(window / side) * side;
    vec2 border = low + side * vec2(greaterThan(perColumn, vec2(0.0)));
    vec2 columns = (border - window) / perColumn;
    // Rounded up, but not where a rounding error would take in one column more. A ray that stays in
    // one pixel never leaves: no image has more columns than this.
    return clamp(floor(min(columns.x, columns.y) + 0.999), 1.0, 65536.0);
}

// How many of these columns the ray passes without reaching what is nearest in the cell.
//   room        how far that is behind the ray at the first of them [windowZ]
//   perColumnZ  by how much the ray's windowZ grows from column to column
float columnsInFront(float columns, float nearest, float room, float perColumnZ)
{
    float inFront = room <= 0.0       ? 0.0
                    : perColumnZ > 0.0 ? min(ceil(room / perColumnZ), columns)
                                       : columns;
    return nearest >= 1.0 ? columns : inFront;
}

TraceResult searchImage(Capture capture, ImageRay ray)
{
    Columns columns = columnsOf(capture, ray, 1.0);
    vec3 perColumn = columns.step * (ray.end - ray.start);
    // A ray that stays in its column or row never leaves a cell on that side.
    vec2 way = mix(perColumn.xy, vec2(1e-9), lessThan(abs(perColumn.xy), vec2(1e-9)));

    Trail trail = trailOf(ray, columns);
    int i = 0;
    while (i < columns.count && !trail.meeting.hit)
    {
        bool reached = false;
        while (i < columns.count && !reached)
        {
            vec3 window = windowAt(ray, columnAt(columns, i));
            vec4 cell = pyramidCell(capture, window.xy);
            vec3 room = cell.xyz - window.z - trail.lookAheadZ;
            float within = columnsWithin(CELL_SIDES.x, window.xy, way);
            float free = max(
                columnsInFront(within, cell.x, room.x, perColumn.z),
                max(columnsInFront(columnsWithin(CELL_SIDES.y, window.xy, way), cell.y, room.y,
                                   perColumn.z),
                    columnsInFront(columnsWithin(CELL_SIDES.z, window.xy, way), cell.z, room.z,
                                   perColumn.z)));
            trail.inFront = trail.inFront || free > 0.0;

            float leastZ = window.z + min(within * perColumn.z, 0.0) + trail.lookAheadZ;
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
