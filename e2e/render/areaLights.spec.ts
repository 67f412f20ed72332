import type { AreaLightShape } from '@farol/renderer/light-options';
import type { RectAreaLight, Scene } from 'three';
import { expect, test } from '../support/benchTest';

interface Result {
  /** PSNR (dB) of a disc and of a tube against the rectangles that they are cut into. */
  psnr: Record<string, number>;
  /** Programs before and after the number of area lights has grown a hundredfold. */
  programs: [number, number];
  /** Luminance of places: below the middle of a box, by an edge of its shadow, in the light; and without shadows. */
  shadow: [number, number, number];
  unshadowed: [number, number, number];
  /** Largest difference of each technique from forward-single-pass, under lights with a range, with shadows. */
  largest: Record<string, number>;
}

// what is compared is a rectangle's approximate horizon with many small ones: the terminator differs
test('discs and tubes are what many rectangles are, shadows are soft, more lights make no program', async ({
  benchPage: page,
}) => {
  const result = await page.evaluate((): Result => {
    const { three: THREE, Bench, compareImages, setLightOptions, techniquesInTurn } = window.testPage;
    const bench = new Bench(96, 72);
    const camera = new THREE.PerspectiveCamera(50, 96 / 72, 0.1, 60);
    camera.position.set(0, 3, 5);
    camera.lookAt(0, 0, 0);
    const white = new THREE.MeshStandardMaterial({ roughness: 0.4 });
    const room = (): Scene => {
      const floor = new THREE.Mesh(new THREE.PlaneGeometry(12, 12), white);
      floor.rotation.x = -Math.PI / 2;
      floor.receiveShadow = true;
      return new THREE.Scene().add(floor);
    };
    const draw = (scene: Scene) => bench.byTechnique('clustered-forward', scene, camera);
    const light = (width: number, height: number, shape: AreaLightShape = 'rectangle'): RectAreaLight => {
      const made = new THREE.RectAreaLight(0xffffff, 5, width, height);
      setLightOptions(made, { shape });
      made.position.set(0, 1.5, 0);
      made.rotation.x = -Math.PI / 2;
      return made;
    };

    const strips = 24;
    const discs = room();
    const tubes = room();
    for (let i = 0; i < strips; i++) {
      const across = ((i + 0.5) / strips) * 2 - 1;
      const strip = light(1.6 * Math.sqrt(1 - across ** 2), 1.2 / strips);
      strip.position.z = 0.6 * across;
      discs.add(strip);
      const angle = ((i + 0.5) / strips) * 2 * Math.PI;
      const side = light(2, 2 * 0.03 * Math.tan(Math.PI / strips));
      side.position.add(new THREE.Vector3(0, Math.sin(angle), Math.cos(angle)).multiplyScalar(0.03));
      side.rotation.x = Math.PI - angle;
      tubes.add(side);
    }
    const psnr = {
      disc: compareImages(draw(discs), draw(room().add(light(1.6, 1.2, 'disc')))).psnr,
      tube: compareImages(draw(tubes), draw(room().add(light(2, 0.06, 'tube')))).psnr,
    };

    const many = room().add(light(1, 1));
    draw(many);
    const before = bench.programs;
    for (let i = 1; i < 100; i++) many.add(light(0.1 + i / 100, 0.2, i % 2 ? 'disc' : 'tube'));
    draw(many);
    const programs: [number, number] = [before, bench.programs];

    bench.webgl.shadowMap.enabled = true;
    const shadowed = room();
    const box = new THREE.Mesh(new THREE.BoxGeometry(1, 0.2, 1), white);
    box.position.y = 0.8;
    box.castShadow = true;
    const lamp = light(0.8, 0.8);
    lamp.position.y = 3;
    lamp.castShadow = true;
    lamp.userData.farol = { range: 9 };
    shadowed.add(box, lamp);
    const above = new THREE.OrthographicCamera(-2, 2, 1.5, -1.5, 0.1, 10);
    above.position.y = 0.5; // below the box
    above.rotation.x = -Math.PI / 2;
    const places = (): [number, number, number] => {
      const image = bench.byTechnique('forward-single-pass', shadowed, above);
      // along a row through the middle: 24 pixels a metre
      const at = (metres: number): number => image.data[(36 * 96 + Math.round(48 + 24 * metres)) * 4];
      return [at(0), at(0.68), at(1.6)];
    };
    const shadow = places();
    const stock = bench.byTechnique('forward-single-pass', shadowed, above);
    const largest: Record<string, number> = {};
    const others = techniquesInTurn(0, ['forward', 'clustered-deferred', 'forward-plus', 'light-prepass']);
    for (const technique of others)
      largest[technique] = compareImages(stock, bench.byTechnique(technique, shadowed, above)).largest;
    lamp.castShadow = false;
    return { psnr, programs, shadow, unshadowed: places(), largest };
  });
  expect(result.psnr.disc).toBeGreaterThan(40);
  expect(result.psnr.tube).toBeGreaterThan(40);
  expect(result.programs[1]).toBe(result.programs[0]);
  const [dark, edge, lit] = result.shadow;
  const [middle, beside, far] = result.unshadowed;
  expect(dark).toBeLessThan(0.05 * middle);
  expect(edge / beside).toBeGreaterThan(0.2);
  expect(edge / beside).toBeLessThan(0.8);
  expect(lit / far).toBeGreaterThan(0.95);
  for (const [technique, largest] of Object.entries(result.largest)) expect(largest, technique).toBeLessThan(0.02);
});
