import { expect, test } from 'vitest';
import { deviceName, isSoftware } from './device';

test.each([
  ['ANGLE (NVIDIA, NVIDIA GeForce RTX 3080 (0x00002206) Direct3D11 vs_5_0 ps_5_0, D3D11)', 'NVIDIA GeForce RTX 3080'],
  ['ANGLE (Apple, ANGLE Metal Renderer: Apple M2 Pro, Unspecified Version)', 'Apple M2 Pro'],
  ['ANGLE (NVIDIA Corporation, NVIDIA H200/PCIe/SSE2, OpenGL 4.5.0)', 'NVIDIA H200'],
  [
    'ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver-5.0.0)',
    'SwiftShader Device (Subzero)',
  ],
  ['ANGLE (Intel, Vulkan 1.4.3 (Intel(R) Graphics (0x00007D55)), Intel open-source Mesa)', 'Intel(R) Graphics'],
  ['ANGLE (NVIDIA, Vulkan 1.4.312 (NVIDIA NVIDIA H200 (0x00002335)), NVIDIA)', 'NVIDIA H200'],
  ['ANGLE (Intel, Mesa Intel(R) UHD Graphics 620 (KBL GT2), OpenGL 4.6)', 'Mesa Intel(R) UHD Graphics 620 (KBL GT2)'],
  ['Mali-G78', 'Mali-G78'],
])('%s is shown as %s', (renderer, name) => expect(deviceName(renderer)).toBe(name));

test('knows programs that draw on the processor', () => {
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
