import { expect, test } from '../support/benchTest';

/** Motions of the camera, metres a frame aside and up. */
const MOTIONS: readonly (readonly [side: number, up: number])[] = [
  [0.05, 0],
  [0, 0.03],
];

test('TAA follows surfaces whose depth polygonOffset has shifted as it follows others, when the camera moves @verify', async ({
  benchPage: page,
}) => {
  const rows = await page.evaluate((motions) => {
    const { Bench, checkedMap, compareImages, effects, supersampled, three } = window.testPage;
    const [width, height] = [160, 120];
    const map = checkedMap({ min: 'LinearMipmapLinear', anisotropy: 8, wrap: 'Repeat' });
    map.repeat.set(2, 2);
    const material = new three.MeshBasicMaterial({ map });
    const floor = new three.Mesh(new three.PlaneGeometry(40, 40), material);
    floor.rotation.x = -Math.PI / 2;
    const scene = new three.Scene();
    scene.add(floor);
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 100);
    camera.position.set(0, 1.4, 4);
    camera.lookAt(0, 0.4, 0);
    const wanted = supersampled(width, height, scene, camera);
    const bench = new Bench(width, height);
    const taa = new effects.TAA();
    bench.farol.effects = [taa];
    const draw = (side: number, up: number) => {
      taa.reset();
      let image = wanted;
      for (let left = 19; left >= 0; left--) {
        camera.position.set(side * left, 1.4 + up * left, 4);
        image = bench.byTechnique('forward-single-pass', scene, camera);
      }
      return compareImages(wanted, image).psnr;
    };
    return motions.flatMap(([side, up]) => {
      material.polygonOffset = false;
      const plain = draw(side, up);
      material.polygonOffset = true;
      return [
        [4, 1],
        [0, 40_000],
      ].map(([factor, units]) => {
        Object.assign(material, { polygonOffsetFactor: factor, polygonOffsetUnits: units });
        return { name: `${side} m aside, ${up} m up, offset ${factor}, ${units}`, plain, psnr: draw(side, up) };
      });
    });
  }, MOTIONS);
  for (const { name, plain, psnr } of rows)
    expect.soft(psnr, `${name}; ${plain} dB without offset`).toBeGreaterThan(plain - 0.3);
});
