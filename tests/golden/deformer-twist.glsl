vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = cos(millis / 1200.0) * 2.8 / 200.0;
  float t1 = t0 * position.y;
  float t2 = cos(t1);
  float t3 = sin(t1);
  float t4 = t3 * t0;
  float t5 = t2 * t0;
  float t6 = position.z * t5 - position.x * t4;
  float t7 = -position.z * t4 - position.x * t5;
  vec3 t8 = vec3(t2 * normal.x + t3 * normal.z, (t7 * t3 - t6 * t2) * normal.x + normal.y + (-t3 * t6 - t2 * t7) * normal.z, t2 * normal.z - t3 * normal.x);
  float t9 = t2 - 1.0;
  offset = vec3(position.x * t9 + position.z * t3, 0.0, position.z * t9 - position.x * t3);
  float t10 = dot(t8, t8);
  float t11 = inversesqrt(t10);
  warpedNormal = t8 * (t10 > 0.0 ? t11 : 0.0);
  warpedPosition = position + offset;
}
