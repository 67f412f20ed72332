import { expect, test } from '../support/benchTest';

test('forward: an object that comes to others of one material is right in its first frame', async ({
  benchPage: page,
}) => {
  const largest = await page.evaluate(() => {
    const { Bench, compareImages, three: THREE } = window.testPage;
    const bench = new Bench(64, 48);
    const scene = new THREE.Scene();
    const material = new THREE.MeshStandardMaterial({ color: 0xcc8866 });
    const ball = new THREE.SphereGeometry(0.7, 16, 12);
    const add = (x: number) => {
      const mesh = new THREE.Mesh(ball, material);
      mesh.position.x = x;
      scene.add(mesh);
    };
    for (let i = 0; i < 4; i++) {
      const light = new THREE.PointLight(new THREE.Color().setHSL(i / 4, 1, 0.5), 5, 6);
      light.position.set(2 * Math.cos(i), 1, 2 * Math.sin(i) + 1);
      scene.add(light);
    }
    const camera = new THREE.PerspectiveCamera(50, 64 / 48, 0.1, 20);
    camera.position.z = 4;
    add(-1);
    bench.byTechnique('forward', scene, camera);
    add(1);
    return compareImages(bench.byTechnique('forward', scene, camera), bench.stock(scene, camera)).largest;
  });
  expect(largest).toBeLessThan(1e-5);
});
