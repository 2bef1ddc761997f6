vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 700.0) * 0.7;
  float t1 = normal.y - t0 * normal.x;
  offset = vec3((position.y - 60.0) * t0, 0.0, 0.0);
  float t2 = normal.x * normal.x + t1 * t1 + normal.z * normal.z;
  float t3 = inversesqrt(t2);
  warpedNormal = vec3(normal.x, t1, normal.z) * (t2 > 0.0 ? t3 : 0.0);
  warpedPosition = position + offset;
}
