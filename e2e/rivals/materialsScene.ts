type Values = Record<string, unknown>;
type Xyz = readonly [number, number, number];

/** Material of each ball of the scene. */
const materials: readonly Values[] = [
  { colour: [0.8, 0.6, 0.4] },
  { map: 'tiles', repeat: 2 },
  { map: 'brick', normalMap: 'brick-normal' },
  { map: 'stone', normalMap: 'stone-normal', normalScale: 2 },
  { normalMap: 'cloth-red-normal', normalScale: -1 },
  { colour: [0.8, 0.6, 0.2], metalness: 1, roughness: 0.35 },
  { colour: [0.5, 0.5, 0.5], roughness: 0.1 },
  { colour: [0.2, 0.2, 0.2], emissive: [0.1, 0.2, 0.6], emissiveIntensity: 1.5 },
  { colour: [0.6, 0.8, 0.6], shading: 'flat' },
  { colour: [0.3, 0.7, 1], transparent: true, opacity: 0.4 },
  { kind: 'basic', colour: [0.4, 0.4, 0.9] },
  { kind: 'basic', map: 'tiles' },
];

const hues: readonly Xyz[] = [
  [1, 0.3, 0.3],
  [0.3, 1, 0.3],
  [0.4, 0.5, 1],
  [1, 1, 0.4],
];

/**
 * A scene of balls of many materials, boxes drawn as instances, and lights of all kinds that other engines get: bytes of
 * a scene file of the engine.
 */
export function materialsScene(): number[] {
  const object = (name: string, place: Values, component: string, values: Values) => ({
    ...{ id: name, name, parent: null },
    components: [
      { type: 'Transform', version: 1, id: `${name}:Transform`, values: place },
      { type: component, version: 1, id: `${name}:${component}`, values },
    ],
  });
  const at = (x: number, y: number, z: number) => ({ position: [x, y, z] });
  const balls = materials.map((values, i) => {
    const place = { ...at((i % 4) * 2.2 - 3.3, 2.2 - Math.floor(i / 4) * 2.2, 0), rotation: [0.3, 0.4, 0.1] };
    return object(`ball ${i}`, { ...place, scale: [1.8, 2, 1.6] }, 'ObjectRenderer', { mesh: 'sphere', ...values });
  });
  const boxes = hues.map((colour, i) => {
    const place = { ...at(i * 1.5 - 2.2, -4, 0), scale: [0.8, 0.8, 0.8] };
    return object(`box ${i}`, place, 'ObjectRenderer', { mesh: 'box', colour, instanced: true });
  });
  const lamps = hues.map((diffuse, i) => {
    const place = at(i % 2 === 0 ? -4 : 4, i < 2 ? 3 : -3, 3);
    return object(`lamp ${i}`, place, 'Light', { type: 'point', diffuse, intensity: 14, range: 12 });
  });
  const file = {
    ...{ format: 'farol-scene', version: 2, name: 'Materials', activeCamera: 'camera', assets: [] },
    settings: { backgroundColour: [0.02, 0.03, 0.06] },
    objects: [
      object('camera', at(0, -0.5, 13), 'Camera', { fov: 0.8, near: 0.5, far: 40 }),
      ...balls,
      ...boxes,
      ...lamps,
      object('sun', { rotation: [-0.6, 0.5, 0] }, 'Light', { type: 'directional', intensity: 0.4 }),
      object('sky', at(0, 5, 0), 'Light', { type: 'hemisphere', groundColour: [0.2, 0.15, 0.1], intensity: 0.4 }),
      object('ambient', {}, 'Light', { type: 'ambient', intensity: 0.1 }),
      object('spot', at(0, 0, 5), 'Light', { type: 'spot', intensity: 40, range: 12, cutoff: 0.35, penumbra: 0.6 }),
    ],
  };
  return [...new TextEncoder().encode(JSON.stringify(file))];
}
