vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = millis / 1000.0;
  float t1 = t0 * 2.0 + position.y * 0.04;
  float t2 = cos(t1) * 0.6;
  float t3 = t0 * 0.5 + position.z * 0.02;
  float t4 = cos(t3) * 0.3;
  float t5 = t0 * 1.5 + position.x * 0.03;
  float t6 = cos(t5) * 0.45;
  float t7 = normal.x + t4 * t6 * normal.y - t6 * normal.z;
  float t8 = normal.y - t2 * normal.x + t6 * t2 * normal.z;
  float t9 = t2 * t4 * normal.x - t4 * normal.y + normal.z;
  float t10 = t7 * t7 + t8 * t8 + t9 * t9;
  float t11 = t10 > 0.0 ? inversesqrt(t10) : 0.0;
  offset = vec3(sin(t1) * 15.0, sin(t3) * 15.0, sin(t5) * 15.0);
  warpedPosition = position + offset;
  warpedNormal = vec3(t7 * t11, t8 * t11, t9 * t11);
}
