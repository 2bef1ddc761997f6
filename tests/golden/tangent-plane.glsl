vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = millis / 800.0;
  vec3 t1 = position.yzx * 0.04 + t0;
  vec3 t2 = cos(t1) * 0.64;
  vec3 t3 = vec3(normal.x + t2.y * t2.z * normal.y - t2.z * normal.z, normal.y - t2.x * normal.x + t2.z * t2.x * normal.z, t2.x * t2.y * normal.x - t2.y * normal.y + normal.z);
  offset = sin(t1) * 16.0;
  float t4 = dot(t3, t3);
  float t5 = inversesqrt(t4);
  warpedNormal = t3 * (t4 > 0.0 ? t5 : 0.0);
  warpedPosition = position + offset;
}
