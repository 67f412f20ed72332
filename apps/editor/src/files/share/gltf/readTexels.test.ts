import { Texture, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { readTexels } from './readTexels';

it('gives up with the graphics device, and says what to do', async () => {
  const webgl = {
    getRenderTarget: () => null,
    setRenderTarget: () => {},
    render: () => {},
    getContext: () => ({ isContextLost: () => true }),
  } as unknown as WebGLRenderer;
  await expect(readTexels(webgl, new Texture(), 1, 1)).rejects.toThrow('graphics device was lost: export again');
});
