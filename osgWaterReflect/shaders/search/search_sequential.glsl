// Every column in turn: the paper's sequential search. One fetch a column.

uniform float osgwr_columnStride; // [pixels] from one column that is looked at to the next

TraceResult searchImage(Capture capture, ImageRay ray)
{
    Columns columns = columnsOf(capture, ray, osgwr_columnStride);
    Trail trail = trailOf(ray, columns);
    int i = 0;
    while (i < columns.count && !trail.meeting.hit)
    {
        bool reached = false;
        while (i < columns.count && !reached)
            reached = reaches(capture, ray, columns, i++, trail);
        if (reached) meet(capture, ray, columns, i - 1, trail);
    }
    return resultOf(capture, ray, columns, trail);
}
