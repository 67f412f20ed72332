import type { WebGLRenderer, WebGLRenderTarget } from 'three';

/** Interval between tests of the GPU's fence (ms). */
const POLL_EVERY = 4;

type Pixels = Uint8Array | Uint8ClampedArray | Uint16Array | Float32Array;

/**
 * Reads RGBA pixels of a render target's first texture without blocking the page, like three's `readRenderTargetPixelsAsync`.
 * three's function still polls its fence after the context was lost and restored, of which browsers warn, since a fence belongs
 * to its context. This one ends with the context, without a warning.
 * @param target - target that was drawn to; its samples are resolved
 * @param x - first pixel from the left, with `y` from below; `width` and `height` in pixels, all within the target
 * @param pixels - receives four values a pixel: bytes, half floats (Uint16Array) or floats, by the type of the target's texture
 * @returns whether the pixels were read; false as soon as the context is lost
 * @throws Error when nothing was drawn to the target yet, or when the browser refuses to wait for the GPU
 */
export async function readPixels(
  webgl: WebGLRenderer,
  target: WebGLRenderTarget,
  x: number,
  y: number,
  width: number,
  height: number,
  pixels: Pixels,
): Promise<boolean> {
  const gl = webgl.getContext() as WebGL2RenderingContext;
  if (gl.isContextLost()) return false;
  const { __webglFramebuffer } = webgl.properties.get(target) as { __webglFramebuffer?: WebGLFramebuffer };
  if (!__webglFramebuffer) throw new Error('The render target has nothing to read yet: draw to it first.');
  webgl.state.bindFramebuffer(gl.FRAMEBUFFER, __webglFramebuffer);
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.bufferData(gl.PIXEL_PACK_BUFFER, pixels.byteLength, gl.STREAM_READ);
  gl.readPixels(x, y, width, height, gl.RGBA, typeOf(gl, pixels), 0);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  webgl.setRenderTarget(webgl.getRenderTarget(), webgl.getActiveCubeFace(), webgl.getActiveMipmapLevel());
  const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0)!;
  gl.flush();
  if (!(await isReached(gl, sync))) return false;
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, pixels);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  gl.deleteBuffer(buffer);
  gl.deleteSync(sync);
  return true;
}

function typeOf(gl: WebGL2RenderingContext, pixels: Pixels): number {
  if (pixels instanceof Float32Array) return gl.FLOAT;
  return pixels instanceof Uint16Array ? gl.HALF_FLOAT : gl.UNSIGNED_BYTE;
}

/** Waits until the GPU reaches a fence. @returns false as soon as the context is lost, and with it the fence */
function isReached(gl: WebGL2RenderingContext, sync: WebGLSync): Promise<boolean> {
  return new Promise((resolve, reject) => {
    const { canvas } = gl;
    const end = (reached: boolean): void => {
      clearTimeout(timer);
      canvas.removeEventListener('webglcontextlost', lose);
      resolve(reached);
    };
    const lose = (): void => end(false);
    const poll = (): void => {
      // the context may be lost before its event is fired
      if (gl.isContextLost()) return end(false);
      const state = gl.clientWaitSync(sync, gl.SYNC_FLUSH_COMMANDS_BIT, 0);
      if (state === gl.TIMEOUT_EXPIRED) {
        timer = setTimeout(poll, POLL_EVERY);
        return;
      }
      if (state === gl.WAIT_FAILED && !gl.isContextLost()) {
        reject(new Error('The browser could not wait for the GPU (clientWaitSync failed): draw again.'));
      }
      end(state !== gl.WAIT_FAILED);
    };
    let timer = setTimeout(poll, POLL_EVERY);
    canvas.addEventListener('webglcontextlost', lose);
  });
}
