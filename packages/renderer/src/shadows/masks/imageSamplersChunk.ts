/**
 * GLSL text of the microshader `imageSamplers`, which samples the textures that spot lights project, with explicit gradients.
 * @param count - number of samplers; GLSL requires constant indices
 */
export function imageSamplersChunk(count: number): string {
  const lines = Array.from(
    { length: count },
    (_, i) => `  if (image == ${i}) return textureGrad(farol_images[${i}], uv, right, up).rgb;\n`,
  );
  return `// Samples the textures that spot lights project.
// Farol
${count > 0 ? `uniform highp sampler2D farol_images[${count}];\n` : ''}
// right, up: change of uv to the next pixels
vec3 farol_imageTexel(const in int image, const in vec2 uv, const in vec2 right, const in vec2 up) {
${lines.join('')}  return vec3(1.0);
}
`;
}
