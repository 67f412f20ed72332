import { REVISION, WebGLRenderer } from 'three';
import { expect, it, vi } from 'vitest';
import { checkCopy } from './checkCopy';

/** Stands for the class of another copy of three. */
const Other = { prototype: {} };

/** A renderer of a class of three's, without a device. @param engine - name of three on its canvas; null for an OffscreenCanvas */
function rendererOf(copy: { readonly prototype: object }, engine: string | null): WebGLRenderer {
  const domElement = engine === null ? {} : { getAttribute: () => engine };
  return Object.assign(Object.create(copy.prototype) as object, { domElement }) as unknown as WebGLRenderer;
}

it('takes renderers of its own copy of three, and of classes that extend them', () => {
  const warn = vi.spyOn(console, 'warn');
  checkCopy(rendererOf(WebGLRenderer, `three.js r${REVISION}`));
  checkCopy(rendererOf(class extends WebGLRenderer {}, null));
  expect(warn).not.toHaveBeenCalled();
});

it('warns of a second copy of the same version, and how to have one', () => {
  const warn = vi.spyOn(console, 'warn').mockReturnValue();
  checkCopy(rendererOf(Other, `three.js r${REVISION}`));
  checkCopy(rendererOf(Other, null));
  expect(warn.mock.calls.map(String)).toEqual([
    expect.stringContaining('loads three twice'),
    expect.stringContaining("resolve.dedupe: ['three']"),
  ]);
});

it('refuses a renderer of another version, and names both', () => {
  expect(() => checkCopy(rendererOf(Other, 'three.js r183'))).toThrow(
    new RegExp(`three\\.js r183 made the WebGLRenderer, Farol imports three\\.js r${REVISION}`),
  );
});
