import {
  AmbientLight,
  BoxGeometry,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshPhongMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  PerspectiveCamera,
  PointLight,
  Scene,
  SpotLight,
} from 'three';

/** A scene with every kind of material and light for which techniques use different shaders. */
export function makeDryScene(): { scene: Scene; camera: PerspectiveCamera; dispose(): void } {
  const scene = new Scene();
  const geometry = new BoxGeometry();
  const materials = [
    new MeshStandardMaterial(),
    new MeshPhysicalMaterial({ clearcoat: 1 }),
    new MeshPhongMaterial(),
    new MeshLambertMaterial(),
    new MeshBasicMaterial(),
    new MeshStandardMaterial({ transparent: true, opacity: 0.5 }),
  ];
  for (const material of materials) scene.add(new Mesh(geometry, material));
  scene.add(new AmbientLight(), new HemisphereLight(), new DirectionalLight());
  for (let i = 0; i < 8; i++) scene.add(new PointLight(0xffffff, 1, 5), new SpotLight(0xffffff, 1, 5, 0.5, 0.2));
  const camera = new PerspectiveCamera(50, 1, 0.1, 100);
  camera.position.z = 3;
  const dispose = (): void => {
    geometry.dispose();
    for (const material of materials) material.dispose();
  };
  return { scene, camera, dispose };
}
