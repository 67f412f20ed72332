import { Color, Group, Mesh, MeshBasicMaterial, PointLight, SphereGeometry } from 'three';

const bulb = new SphereGeometry(0.05, 12, 8);

/** 200 lamps, each a light with a visible bulb. */
export const lamps = new Group();
for (let i = 0; i < 200; i++) {
  const colour = new Color().setHSL((i * 0.37) % 1, 0.8, 0.6);
  // intensity in candela, range in metres: lights of short range are cheap to draw
  const lamp = new PointLight(colour, 2, 3);
  lamp.add(new Mesh(bulb, new MeshBasicMaterial({ color: colour })));
  lamps.add(lamp);
}

/** Moves each lamp on its orbit, to a time in seconds. */
export function moveLamps(seconds = 0) {
  lamps.children.forEach((lamp, i) => {
    const radius = 1 + 9 * Math.sqrt(i / 200);
    const angle = i * 2.4 + (seconds * (i % 2 === 0 ? 1 : -1)) / radius;
    lamp.position.set(radius * Math.cos(angle), 0.7 + 0.5 * Math.sin(seconds + i), radius * Math.sin(angle));
  });
}
