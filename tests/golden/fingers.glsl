vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.y / -200.0;
  float t1 = clamp(t0, 0.0, 1.0);
  float t2 = position.x * 0.03 + millis / 250.0;
  float t3 = sin(t2);
  float t4 = t1 * t1;
  float t5 = t1 * (t0 < 0.0 || t0 > 1.0 ? 0.0 : -0.005);
  float t6 = normal.x - t4 * (cos(t2) * 0.03) * 70.0 * normal.z;
  float t7 = normal.y - t3 * (t5 + t5) * 70.0 * normal.z;
  float t8 = t6 * t6 + t7 * t7 + normal.z * normal.z;
  float t9 = t8 > 0.0 ? inversesqrt(t8) : 0.0;
  offset = vec3(0.0, 0.0, t4 * t3 * 70.0);
  warpedPosition = position + offset;
  warpedNormal = vec3(t6 * t9, t7 * t9, normal.z * t9);
}
