vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 700.0) * 0.7;
  float t1 = normal.y - t0 * normal.x;
  offset = vec3((position.y - 60.0) * t0, 0.0, 0.0);
  float t2 = normal.x * normal.x + t1 * t1 + normal.z * normal.z;
  float t3 = inversesqrt(t2);
  float t4 = t2 > 0.0 ? t3 : 0.0;
  bool t5 = t2 < 1e38;
  warpedNormal = (t5 ? vec3(normal.x, t1, normal.z) : vec3(0.0)) * t4;
  warpedPosition = position + offset;
}
