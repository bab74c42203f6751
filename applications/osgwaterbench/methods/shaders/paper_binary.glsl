// Halving, as if a ray that is behind something once stayed behind.
int searchColumns(ImageColumns columns, vec3 originEye, vec3 dirEye)
{
    int front = -1;
    int behind = columns.count;
    while (behind - front > 1)
    {
        int middle = (front + behind) / 2;
        if (isBehind(crossingAt(columns, middle), columns.alongX, originEye, dirEye))
            behind = middle;
        else
            front = middle;
    }
    return behind;
}
