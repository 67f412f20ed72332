{
  float farol_opacity = clamp(gl_FragColor.a, 0.0, 1.0);
  // weight: equation 10 of McGuire and Bavoil 2013, as in their published code
  float farol_weight = clamp(pow(min(1.0, farol_opacity * 10.0) + 0.01, 3.0) * 1e8
    * pow(1.0 - gl_FragCoord.z * 0.9, 3.0), 1e-2, 3e3);
  #ifndef PREMULTIPLIED_ALPHA
    gl_FragColor.rgb *= farol_opacity;
  #endif
  gl_FragColor = vec4(gl_FragColor.rgb * farol_weight, farol_opacity);
  farol_outWeight = vec4(farol_opacity * farol_weight, 0.0, 0.0, 0.0);
}
