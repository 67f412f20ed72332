import {
  BoxGeometry,
  Color,
  CylinderGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  PlaneGeometry,
  PointLight,
  SphereGeometry,
  TorusKnotGeometry,
} from 'three';

/** A floor, two walls and five bodies, all of Phong materials; lengths in m, the middle of the floor at the origin. */
export function room(): Group {
  const group = new Group();
  const add = (
    name: string,
    geometry: ConstructorParameters<typeof Mesh>[0],
    color: number,
    shininess: number,
  ): Mesh => {
    const specular = new Color().setScalar(shininess > 10 ? 0.2 : 0.03);
    const mesh = new Mesh(geometry, new MeshPhongMaterial({ color, shininess, specular }));
    mesh.name = name;
    group.add(mesh);
    return mesh;
  };
  add('floor', new PlaneGeometry(10, 10), 0x9b9690, 6).rotation.x = -Math.PI / 2;
  add('back wall', new PlaneGeometry(10, 4), 0x8a8fa0, 4).position.set(0, 2, -5);
  const side = add('side wall', new PlaneGeometry(10, 4), 0xa08a80, 4);
  side.position.set(-5, 2, 0);
  side.rotation.y = Math.PI / 2;
  add('ball', new SphereGeometry(0.9, 48, 32), 0xc8c8cc, 90).position.set(-1.9, 0.9, 0.3);
  add('column', new CylinderGeometry(0.55, 0.6, 2.6, 40), 0xc2a878, 20).position.set(2.2, 1.3, -1.6);
  add('box', new BoxGeometry(1.3, 1.3, 1.3), 0x7890b8, 40).position.set(0.4, 0.65, 1.7);
  group.getObjectByName('box')!.rotation.y = 0.5;
  add('knot', new TorusKnotGeometry(0.6, 0.2, 96, 16), 0x9ab87a, 60).position.set(0.1, 1.6, -1.4);
  return group;
}

/** Point lights in circles above the floor, each with a bulb. */
export interface Lamps {
  readonly group: Group;
  readonly lights: readonly PointLight[];
  /** Moves the lamps to their places at a time (s). */
  move(seconds: number): void;
}

/**
 * @param range - distance (m) at which each lamp's light ends
 * @param intensity - of each lamp (cd)
 */
export function lamps(count: number, range = 3.2, intensity = 4): Lamps {
  const group = new Group();
  const bulb = new SphereGeometry(0.05, 12, 8);
  const lights = Array.from({ length: count }, (_, i) => {
    const color = new Color().setHSL((i * 0.381966) % 1, 0.75, 0.6);
    const light = new PointLight(color, intensity, range);
    light.add(new Mesh(bulb, new MeshBasicMaterial({ color })));
    group.add(light);
    return light;
  });
  const move = (seconds: number): void =>
    lights.forEach(({ position }, i) => {
      const radius = 4.2 * Math.sqrt((i + 0.5) / count);
      const angle = 2.399963 * i + (i % 2 === 0 ? 0.25 : -0.18) * seconds;
      position.set(radius * Math.cos(angle), 0.5 + ((i * 0.618) % 1) * 1.6, radius * Math.sin(angle));
    });
  move(0);
  return { group, lights, move };
}
