// Every column in turn.
int searchColumns(ImageColumns columns, vec3 originEye, vec3 dirEye)
{
    int i = 0;
    while (i < columns.count &&
           !isBehind(crossingAt(columns, i), columns.alongX, originEye, dirEye))
        ++i;
    return i;
}
