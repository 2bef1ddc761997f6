vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.y * 20.0 + millis * 0.002;
  float t1 = position.z * 10.0 + millis * 0.0005;
  float t2 = position.x * 15.0 + millis * 0.0015;
  float t3 = cos(t2) * 0.75;
  offset = vec3(sin(t0) * 0.05, sin(t1) * 0.05, sin(t2) * 0.05);
  float t4 = cos(t0);
  float t5 = cos(t1) * 0.5;
  float t6 = normal.x + t5 * t3 * normal.y - t3 * normal.z;
  float t7 = normal.y - t4 * normal.x + t3 * t4 * normal.z;
  float t8 = t4 * t5 * normal.x - t5 * normal.y + normal.z;
  float t9 = t6 * t6 + t7 * t7 + t8 * t8;
  float t10 = t9 > 0.0 ? inversesqrt(t9) : 0.0;
  warpedNormal = vec3(t6 * t10, t7 * t10, t8 * t10);
  warpedPosition = position + offset;
}
