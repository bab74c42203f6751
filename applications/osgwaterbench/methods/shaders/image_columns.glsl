// The image columns (rows where it is steeper) whose pixel centres a line in the image passes.
struct ImageColumns
{
    vec2 start;           // of the line [pixels]
    vec2 extent;          // from there to its end [pixels]
    bool alongX;          // columns; else rows
    float firstCentre;    // of the first of them [pixels]
    float direction;      // +1 or -1: from one to the next
    int count;
};

ImageColumns columnsBetween(vec2 start, vec2 end)
{
    ImageColumns columns;
    columns.start = start;
    columns.extent = end - start;
    columns.alongX = abs(columns.extent.x) >= abs(columns.extent.y);
    float from = columns.alongX ? start.x : start.y;
    float extent = columns.alongX ? columns.extent.x : columns.extent.y;
    columns.direction = extent < 0.0 ? -1.0 : 1.0;
    // Centres lie at halves.
    columns.firstCentre = extent < 0.0 ? ceil(from - 0.5) - 0.5 : floor(from + 0.5) + 0.5;
    float beyondFirst = abs(extent) - abs(columns.firstCentre - from);
    columns.count = beyondFirst < 0.0 ? 0 : int(beyondFirst) + 1;
    return columns;
}

// Where the line is, [0, 1], at the centres of a column.
float shareAt(ImageColumns columns, int i)
{
    float centre = columns.firstCentre + columns.direction * float(i);
    float from = columns.alongX ? columns.start.x : columns.start.y;
    return (centre - from) / (columns.alongX ? columns.extent.x : columns.extent.y);
}

// Where it crosses the column [pixels].
vec2 crossingAt(ImageColumns columns, int i)
{
    float centre = columns.firstCentre + columns.direction * float(i);
    vec2 window = columns.start + shareAt(columns, i) * columns.extent;
    return columns.alongX ? vec2(centre, window.y) : vec2(window.x, centre);
}
