/**
 * Model of a graphics device, without the parts that ANGLE and drivers add: `NVIDIA GeForce RTX 3080` for `ANGLE
 * (NVIDIA, NVIDIA GeForce RTX 3080 (0x00002206) Direct3D11 vs_5_0 ps_5_0, D3D11)`.
 */
export function deviceName(renderer: string): string {
  const inside = /^ANGLE \((?:[^,]*), (.*), [^,]*\)$/.exec(renderer)?.[1] ?? renderer;
  const metal = /^ANGLE Metal Renderer: (.*)$/.exec(inside)?.[1] ?? inside;
  const vulkan = /^Vulkan [\d.]+ \((.*)\)$/.exec(metal)?.[1] ?? metal;
  return (
    vulkan
      .replace(/ \(0x[0-9a-f]+\)/gi, '')
      .replace(/ (Direct3D\d*|OpenGL( ES)?|Vulkan [\d.]+).*$/, '')
      .replace(/\/PCIe\/SSE2$/, '')
      // some drivers repeat the vendor's name
      .replace(/^(\S+) \1 /, '$1 ')
      .trim()
  );
}

/** Whether a device is a software rasteriser, which draws on the CPU, by its name. */
export const isSoftware = (device: string): boolean =>
  /swiftshader|llvmpipe|softpipe|software|basic render|warp/i.test(device);
