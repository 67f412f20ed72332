import { RGFormat, UnsignedByteType, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { GBuffer } from './GBuffer';
import { formatOf } from './gbufferLayout';

const extensions = { has: () => true };
const webgl = { extensions, getContext: () => ({ getParameter: () => 8 }) } as unknown as WebGLRenderer;
const extra = { name: 'extra', format: RGFormat, type: UnsignedByteType, bytes: 2 };

/** Bytes of a pixel, by the layout, and by the targets without depth. */
const bytesOf = (...settings: [extras: (typeof extra)[], storesDistance: boolean, isLite: boolean]) => {
  const gbuffer = new GBuffer(webgl, ...settings);
  gbuffer.setSize(3, 5);
  const rows = gbuffer.layout.reduce((sum, row) => sum + formatOf(row, gbuffer.isLite).bytes, 0);
  return [rows, gbuffer.bytes / 15 - 4];
};

it('has 20 bytes a pixel, 14 with the quality lite, and what is stored beside', () => {
  expect(bytesOf([], false, false)).toEqual([20, 20]);
  expect(bytesOf([], false, true)).toEqual([14, 14]);
  expect(bytesOf([extra], true, true)).toEqual([16, 20]);
});
