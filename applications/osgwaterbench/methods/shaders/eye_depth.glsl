// Distance along the view's axis of what is seen at a windowZ [world units]; perspective only.
float eyeDepthAt(float windowZ)
{
    return eyeCapture.imageFromEye[3][2] / (1.0 - windowZ + eyeCapture.imageFromEye[2][2]);
}
