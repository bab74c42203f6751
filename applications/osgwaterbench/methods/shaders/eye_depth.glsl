// Distance along the view's axis of what is seen at a windowZ [world units]; perspective only.
float eyeDepthAt(float windowZ)
{
    return eyeCapture.clipFromEye[3][2] / (2.0 * windowZ - 1.0 + eyeCapture.clipFromEye[2][2]);
}
