import {
  BoxGeometry,
  Color,
  CylinderGeometry,
  HemisphereLight,
  InstancedMesh,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  Object3D,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  SphereGeometry,
  SpotLight,
  TorusKnotGeometry,
} from 'three';

/** A scene of three.js alone, without Farol. */
export interface Lanterns {
  scene: Scene;
  camera: PerspectiveCamera;
  /** Emissive object in the middle. */
  knot: Mesh;
  /** Moves the lights to their places at a time (s). */
  update(seconds: number): void;
}

const LANTERNS = 24;

/** A ring of columns, a knot and a pane of glass, under 24 circling lanterns and a spot light. Lengths in m. */
export function lanterns(): Lanterns {
  const scene = new Scene();
  scene.background = new Color(0x10141c);
  scene.add(new HemisphereLight(0x8fa8d8, 0x40342a, 0.35));

  const floor = new Mesh(new PlaneGeometry(24, 24), new MeshStandardMaterial({ color: 0x9a9488, roughness: 0.75 }));
  floor.name = 'floor';
  floor.rotation.x = -Math.PI / 2;
  scene.add(floor);

  const columns = new InstancedMesh(
    new CylinderGeometry(0.35, 0.42, 4, 24),
    new MeshPhongMaterial({ color: 0xd8d0c0, shininess: 40 }),
    10,
  );
  columns.name = 'columns';
  const place = new Object3D();
  for (let i = 0; i < columns.count; i++) {
    const angle = (i / columns.count) * 2 * Math.PI;
    place.position.set(5 * Math.cos(angle), 2, 5 * Math.sin(angle));
    place.updateMatrix();
    columns.setMatrixAt(i, place.matrix);
  }
  scene.add(columns);

  const knot = new Mesh(
    new TorusKnotGeometry(0.8, 0.26, 120, 20),
    new MeshStandardMaterial({ color: 0xc98f5a, metalness: 0.6, roughness: 0.35 }),
  );
  knot.name = 'knot';
  knot.position.y = 1.7;
  scene.add(knot);

  const chest = new Mesh(
    new BoxGeometry(1, 0.8, 1),
    new MeshPhysicalMaterial({ color: 0x5a7fb0, roughness: 0.5, clearcoat: 1, clearcoatRoughness: 0.2 }),
  );
  chest.name = 'chest';
  chest.position.set(-2, 0.4, 1.6);
  scene.add(chest);

  const pane = new Mesh(
    new BoxGeometry(1.6, 2, 0.05),
    new MeshStandardMaterial({ color: 0x88c0a8, transparent: true, opacity: 0.45, roughness: 0.3 }),
  );
  pane.name = 'pane';
  pane.position.set(1.6, 1.2, 1.8);
  pane.rotation.y = -0.5;
  scene.add(pane);

  const spot = new SpotLight(0xfff0d8, 60, 14, 0.5, 0.5);
  spot.name = 'spot';
  spot.position.set(3, 6, 3);
  spot.target.position.set(0, 1, 0);
  scene.add(spot, spot.target);

  const bulb = new SphereGeometry(0.07, 12, 8);
  const lights = Array.from({ length: LANTERNS }, (_, i) => {
    const light = new PointLight(new Color().setHSL(i / LANTERNS, 0.7, 0.6), 5, 5);
    light.name = `lantern ${i + 1}`;
    light.add(new Mesh(bulb, new MeshBasicMaterial({ color: light.color })));
    scene.add(light);
    return light;
  });

  const camera = new PerspectiveCamera(50, 16 / 9, 0.1, 60);
  camera.position.set(0, 3.4, 8.5);
  camera.lookAt(0, 1.4, 0);

  const update = (seconds: number) => {
    lights.forEach((light, i) => {
      const angle = (i / LANTERNS) * 2 * Math.PI + 0.2 * seconds * (i % 2 ? 1 : -1);
      const radius = 2.2 + 1.7 * (i % 3);
      light.position.set(radius * Math.cos(angle), 0.6 + 0.5 * (i % 4), radius * Math.sin(angle));
    });
    knot.rotation.set(0.3 * seconds, 0.5 * seconds, 0);
  };
  update(0);
  return { scene, camera, knot, update };
}
