vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x * 0.34;
  float t1 = (position.y * -0.5 + 0.5) * bend;
  float t2 = 1.5 / bend;
  float t3 = position.x * 0.36992;
  float t4 = bend * -0.5;
  float t5 = t2 - (position.z * 0.04 - t0 * t0 * 1.6);
  float t6 = sin(t1);
  float t7 = cos(t1);
  offset = vec3(t0, -t6 * t5, t2 - t7 * t5) - position;
  float t8 = t6 * t3;
  float t9 = t7 * t3;
  float t10 = t5 * (t7 * t4);
  float t11 = t5 * (t6 * t4);
  float t12 = t6 * -0.04;
  float t13 = t7 * -0.04;
  float t14 = (t10 * t13 + t11 * t12) * normal.x;
  float t15 = (t12 * t9 - t13 * t8) * normal.y;
  float t16 = (-t8 * t11 - t9 * t10) * normal.z;
  vec3 t17 = vec3(t14 + t15 + t16, t7 * 0.0136 * normal.y - t11 * 0.34 * normal.z, t10 * -0.34 * normal.z - t6 * 0.0136 * normal.y);
  float t18 = abs(t17.x) + abs(t17.y) + abs(t17.z);
  vec3 t19 = t17 / t18;
  float t20 = inversesqrt(dot(t19, t19));
  vec3 t21 = t19 * t20;
  warpedNormal = t18 > 0.0 && t18 < 1e38 ? t21 : vec3(0.0);
  warpedPosition = position + offset;
}
