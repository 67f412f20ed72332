import type * as THREE from 'three';
import { Bench, type PageImage } from './Bench';

/** A scene by stock three with 16 samples a pixel, on a grid, averaged in linear light: what anti-aliasing aims at. */
export function supersampled(width: number, height: number, scene: THREE.Scene, camera: THREE.Camera): PageImage {
  const bench = new Bench(width * 4, height * 4);
  const { data } = bench.stock(scene, camera);
  bench.free();
  const mean = new Float32Array(width * height * 4);
  for (let y = 0; y < height * 4; y++) {
    for (let x = 0; x < width * 4; x++) {
      const to = ((y >> 2) * width + (x >> 2)) * 4;
      for (let c = 0; c < 4; c++) mean[to + c] += data[(y * width * 4 + x) * 4 + c] / 16;
    }
  }
  return { width, height, data: mean };
}
