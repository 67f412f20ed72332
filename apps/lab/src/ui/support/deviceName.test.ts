import { expect, test } from 'vitest';
import { deviceName } from './deviceName';

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
  ['Mali-G78', 'Mali-G78'],
])('%s is shown as %s', (renderer, name) => expect(deviceName(renderer)).toBe(name));
