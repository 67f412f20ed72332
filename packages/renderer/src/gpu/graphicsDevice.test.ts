import { expect, it } from 'vitest';
import { isSoftwareRasteriser } from './graphicsDevice';

const context = (name: string, tells = true) =>
  ({
    RENDERER: 1,
    getExtension: () => (tells ? { UNMASKED_RENDERER_WEBGL: 2 } : null),
    getParameter: (of: number) => (of === 2 ? name : tells ? 'WebKit WebGL' : name),
  }) as unknown as WebGL2RenderingContext;

it.each([
  'ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)',
  'llvmpipe (LLVM 15.0.7, 256 bits)',
  'ANGLE (Microsoft, Microsoft Basic Render Driver Direct3D11 vs_5_0 ps_5_0, D3D11)',
])('%s is a software rasteriser, whether the name is told by the extension or not', (name) => {
  expect(isSoftwareRasteriser(context(name))).toBe(true);
  expect(isSoftwareRasteriser(context(name, false))).toBe(true);
});

it.each(['ANGLE (NVIDIA, NVIDIA GeForce RTX 3080 Direct3D11 vs_5_0 ps_5_0, D3D11)', 'Adreno (TM) 640', 'Apple GPU'])(
  '%s is none',
  (name) => expect(isSoftwareRasteriser(context(name))).toBe(false),
);
