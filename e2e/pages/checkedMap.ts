import * as THREE from 'three';

const minFilters = {
  Nearest: THREE.NearestFilter,
  Linear: THREE.LinearFilter,
  NearestMipmapNearest: THREE.NearestMipmapNearestFilter,
  LinearMipmapNearest: THREE.LinearMipmapNearestFilter,
  LinearMipmapLinear: THREE.LinearMipmapLinearFilter,
};

/** Sampling of an image, by names of three's constants. */
export interface CheckedSampling {
  readonly min: keyof typeof minFilters;
  readonly mag?: 'Nearest' | 'Linear';
  readonly wrap?: 'Repeat' | 'MirroredRepeat';
  readonly anisotropy?: number;
  /** Texels a side. */
  readonly side?: number;
}

/** An image of checks of one texel, which shows all that a sampler does. */
export function checkedMap({
  min,
  mag = 'Linear',
  wrap,
  anisotropy = 1,
  side = 64,
}: CheckedSampling): THREE.DataTexture {
  const checks = new Uint8Array(side * side * 4).fill(255);
  for (let i = 0; i < side * side; i++) if (((i % side) + Math.floor(i / side)) % 2) checks.set([40, 90, 20], i * 4);
  const map = new THREE.DataTexture(checks, side, side);
  map.colorSpace = THREE.SRGBColorSpace;
  map.generateMipmaps = min.includes('Mipmap');
  map.minFilter = minFilters[min];
  map.magFilter = mag === 'Nearest' ? THREE.NearestFilter : THREE.LinearFilter;
  if (wrap) map.wrapS = map.wrapT = wrap === 'Repeat' ? THREE.RepeatWrapping : THREE.MirroredRepeatWrapping;
  map.anisotropy = anisotropy;
  map.needsUpdate = true;
  return map;
}
