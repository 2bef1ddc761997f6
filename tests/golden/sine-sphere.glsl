vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = millis / 700.0;
  vec3 t1 = vec3(position.y * 7.0 + t0, position.z * 7.0 + t0 + 2.0, position.x * 7.0 + t0 + 4.0);
  vec3 t2 = cos(t1) * 0.91;
  vec3 t3 = vec3(normal.x + t2.y * t2.z * normal.y - t2.z * normal.z, normal.y - t2.x * normal.x + t2.z * t2.x * normal.z, t2.x * t2.y * normal.x - t2.y * normal.y + normal.z);
  offset = sin(t1) * 0.13;
  float t4 = dot(t3, t3);
  float t5 = inversesqrt(t4);
  warpedNormal = t3 * (t4 > 0.0 ? t5 : 0.0);
  warpedPosition = position + offset;
}
