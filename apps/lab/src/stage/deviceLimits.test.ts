import { expect, it } from 'vitest';
import { isSoftware } from './deviceLimits';

it('knows programs that draw on the processor', () => {
  const software = [
    'ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)',
    'llvmpipe (LLVM 15.0.7, 256 bits)',
    'ANGLE (Microsoft, Microsoft Basic Render Driver (0x0000008C) Direct3D11 vs_5_0 ps_5_0, D3D11)',
    'Mesa/X.org, softpipe',
  ];
  const hardware = [
    'ANGLE (NVIDIA, Vulkan 1.3.277 (NVIDIA H200 (0x00002335)), NVIDIA)',
    'ANGLE (Apple, ANGLE Metal Renderer: Apple M2, Unspecified Version)',
    'ANGLE (Intel, Intel(R) Iris(R) Xe Graphics Direct3D11 vs_5_0 ps_5_0, D3D11)',
    'Adreno (TM) 640',
  ];
  expect(software.filter((name) => !isSoftware(name))).toEqual([]);
  expect(hardware.filter(isSoftware)).toEqual([]);
});
