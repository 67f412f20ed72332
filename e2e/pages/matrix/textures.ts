import * as THREE from 'three';

/** A smooth texture of 64 × 64 texels, wrapped, from a function of place (0..1) that gives red, green, blue, alpha (0..1). */
export function smoothTexture(
  colour: (u: number, v: number) => readonly [number, number, number, number],
  colorSpace: THREE.ColorSpace = THREE.NoColorSpace,
): THREE.DataTexture {
  const size = 64;
  const data = new Uint8Array(size * size * 4);
  for (let i = 0; i < size * size; i++) {
    const texel = colour(((i % size) + 0.5) / size, (Math.floor(i / size) + 0.5) / size);
    data.set(
      texel.map((value) => Math.round(Math.min(1, Math.max(0, value)) * 255)),
      i * 4,
    );
  }
  const texture = new THREE.DataTexture(data, size, size);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.colorSpace = colorSpace;
  texture.needsUpdate = true;
  return texture;
}

const wave = (t: number) => 0.5 + 0.5 * Math.sin(t * Math.PI * 4);

export const colourMap = () =>
  smoothTexture((u, v) => [0.4 + 0.6 * wave(u), 0.5 + 0.5 * wave(v), 0.7, 1], THREE.SRGBColorSpace);
/** Half floats from 0 to 3. */
export const brightMap = () => {
  const values = [0.2, 3, 1.5, 0.7].flatMap((value) => [value, 3 - value, 0.5, 1].map(THREE.DataUtils.toHalfFloat));
  const texture = new THREE.DataTexture(Uint16Array.from(values), 2, 2, THREE.RGBAFormat, THREE.HalfFloatType);
  texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
};
export const greyMap = () =>
  smoothTexture((u, v) => [0.4 + 0.5 * wave(u), 0.4 + 0.5 * wave(v), 0.3 + 0.6 * wave(u + v), 1]);
/** Alpha and green from 0 to 1, for alpha maps and tests. */
export const holes = () =>
  smoothTexture(
    (u, v) => [0.9, wave(u) * 0.6 + wave(v) * 0.4, 0.8, wave(u) * 0.6 + wave(v) * 0.4],
    THREE.SRGBColorSpace,
  );
export const normalMap = () =>
  smoothTexture((u, v) => [0.5 + 0.2 * Math.sin(u * 25), 0.5 + 0.2 * Math.cos(v * 25), 0.9, 1]);
/** Unit normals of a tilted sphere in object space. */
export const objectNormalMap = () =>
  smoothTexture((u, v) => {
    const normal = new THREE.Vector3().setFromSphericalCoords(
      1,
      (1 - v) * Math.PI * 0.9 + 0.1,
      (u - 0.25) * Math.PI * 2,
    );
    return [normal.x * 0.5 + 0.5, normal.y * 0.5 + 0.5, normal.z * 0.5 + 0.5, 1];
  });

/** Six faces of one colour each, a little shaded. */
export function cubeMap(): THREE.CubeTexture {
  const faces = [0xcc5544, 0x44cc55, 0x5544cc, 0xcccc44, 0x44cccc, 0xcc44cc].map((hex) => {
    const { r, g, b } = new THREE.Color(hex);
    return smoothTexture((u, v) => [r * (0.6 + 0.4 * u), g * (0.6 + 0.4 * v), b, 1], THREE.SRGBColorSpace);
  });
  const texture = new THREE.CubeTexture(faces as unknown as HTMLImageElement[]);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.generateMipmaps = false;
  texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export function equirect(): THREE.DataTexture {
  const texture = smoothTexture((u, v) => [0.3 + 0.5 * wave(u), v, 0.6 * wave(u + 0.3), 1], THREE.SRGBColorSpace);
  texture.mapping = THREE.EquirectangularReflectionMapping;
  return texture;
}
