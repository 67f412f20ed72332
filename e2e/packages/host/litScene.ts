import {
  AmbientLight,
  BoxGeometry,
  Color,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  PointLight,
  Scene,
  SpotLight,
} from 'three';

/** Six boxes on a floor under 24 point lights and a spot light that casts shadows. */
export function litScene(): Scene {
  const scene = new Scene();
  scene.background = new Color(0x101820);
  const floor = new Mesh(new PlaneGeometry(12, 12), new MeshStandardMaterial({ roughness: 0.8 }));
  floor.rotation.x = -Math.PI / 2;
  floor.receiveShadow = true;
  scene.add(floor, new AmbientLight(0x404040));
  for (let i = 0; i < 6; i++) {
    const box = new Mesh(new BoxGeometry(), new MeshStandardMaterial({ color: new Color().setHSL(i / 6, 0.5, 0.5) }));
    box.position.set((i % 3) * 2.2 - 2.2, 0.5, i < 3 ? 1.5 : -1.5);
    box.castShadow = true;
    scene.add(box);
  }
  for (let i = 0; i < 24; i++) {
    const light = new PointLight(new Color().setHSL(i / 24, 0.8, 0.6), 2, 3);
    light.position.set((i % 6) * 1.8 - 4.5, 0.8, Math.floor(i / 6) * 1.8 - 2.7);
    scene.add(light);
  }
  const spot = new SpotLight(0xffffff, 60, 15, 0.5, 0.5);
  spot.position.set(3, 6, 3);
  spot.castShadow = true;
  scene.add(spot, spot.target);
  return scene;
}
