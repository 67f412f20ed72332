import {
  BoxGeometry,
  Group,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  SphereGeometry,
  TorusKnotGeometry,
} from 'three';

const grey = new MeshStandardMaterial({ color: 'gray', roughness: 0.5 });
const gold = new MeshStandardMaterial({ color: 'gold', roughness: 0.3, metalness: 0.6 });

/** A floor with a knot in the middle, surrounded by columns and balls. */
export const objects = new Group();
const floor = new Mesh(new PlaneGeometry(60, 60), grey);
floor.rotation.x = -Math.PI / 2;
const knot = new Mesh(new TorusKnotGeometry(1, 0.3, 200, 32), gold);
knot.position.y = 1.8;
objects.add(floor, knot);

const column = new BoxGeometry(0.6, 3, 0.6);
const ball = new SphereGeometry(0.45, 32, 16);
for (let i = 0; i < 24; i++) {
  const angle = ((i + 0.5) / 6) * Math.PI;
  const isColumn = i < 12;
  const object = new Mesh(isColumn ? column : ball, isColumn ? grey : gold);
  const radius = isColumn ? 7 : 4;
  object.position.set(radius * Math.cos(angle), isColumn ? 1.5 : 0.45, radius * Math.sin(angle));
  objects.add(object);
}
