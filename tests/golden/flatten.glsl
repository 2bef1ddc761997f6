vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = normal.x * normal.x;
  float t1 = inversesqrt(t0);
  warpedNormal = vec3(normal.x * (t0 > 0.0 ? t1 : 0.0), 0.0, 0.0);
  offset = vec3(-position.x, 0.0, 0.0);
  warpedPosition = position + offset;
}
