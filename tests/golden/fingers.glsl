vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.y / -200.0;
  float t1 = position.x * 0.03 + millis / 250.0;
  float t2 = clamp(t0, 0.0, 1.0);
  float t3 = sin(t1);
  float t4 = normal.y - t3 * (t2 * 2.0 * (t0 < 0.0 || t0 > 1.0 ? 0.0 : -0.005)) * 70.0 * normal.z;
  float t5 = t2 * t2;
  float t6 = normal.x - t5 * (cos(t1) * 0.03) * 70.0 * normal.z;
  offset = vec3(0.0, 0.0, t5 * t3 * 70.0);
  float t7 = t6 * t6 + t4 * t4 + normal.z * normal.z;
  float t8 = inversesqrt(t7);
  warpedNormal = vec3(t6, t4, normal.z) * (t7 > 0.0 ? t8 : 0.0);
  warpedPosition = position + offset;
}
