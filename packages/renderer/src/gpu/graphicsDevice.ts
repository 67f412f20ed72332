/** Name of a context's graphics device, from WEBGL_debug_renderer_info where the browser has it. */
export function graphicsDevice(gl: WebGL2RenderingContext): string {
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  return String(gl.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
}

/** Whether a context draws on the CPU: SwiftShader, Mesa's llvmpipe and softpipe, Microsoft's WARP. */
export function isSoftwareRasteriser(gl: WebGL2RenderingContext): boolean {
  return /swiftshader|llvmpipe|softpipe|software|basic render|\bwarp\b/i.test(graphicsDevice(gl));
}
