import { expect, test } from '../support/benchTest';

/**
 * Depth does not tell how far surfaces are here: shifted by `polygonOffset`, or of an oblique near plane. Ambient occlusion is
 * that of the plain picture, whose surfaces lie in the same places.
 */
const TECHNIQUES = ['deferred', 'tiled-deferred', 'clustered-deferred', 'light-prepass', 'forward-plus'] as const;

const cases = [
  { name: 'a sheet on the floor, by polygonOffset of -2 and -4', factor: -2, units: -4 },
  { name: 'a sheet on the floor, by polygonOffset of -40,000 units', factor: 0, units: -40_000 },
  { name: 'the floor, by polygonOffset of 3', factor: 3, units: 1, isWhole: true },
  { name: 'a sheet by an orthographic camera', factor: -2, units: -40_000, isOrthographic: true },
  { name: 'a sheet, in reversed depth', factor: -2, units: -4, isReversed: true },
  { name: 'an oblique near plane', isOblique: true },
] as const;

for (const [turn, { name, ...options }] of cases.entries()) {
  test(`ambient occlusion is that of surfaces in their places: ${name}${turn % 3 > 0 ? ' @verify' : ''}`, async ({
    benchPage: page,
  }) => {
    const rows = await page.evaluate(
      ({ turn, techniques, options }) => {
        const { Bench, compareImages, effects, techniquesInTurn, three } = window.testPage;
        const {
          factor = 0,
          units = 0,
          isWhole,
          isOrthographic,
          isReversed,
          isOblique,
        } = options as Partial<Record<'factor' | 'units', number> & Record<`is${string}`, boolean>>;
        const [width, height] = [160, 120];
        const bench = new Bench(width, height, { renderer: { reversedDepthBuffer: isReversed === true } });
        const material = new three.MeshStandardMaterial({ roughness: 1 });
        const shifted = new three.MeshStandardMaterial({ roughness: 1 });
        const floor = new three.Mesh(new three.PlaneGeometry(40, 40), isWhole ? shifted : material);
        floor.rotation.x = -Math.PI / 2;
        const wall = new three.Mesh(new three.PlaneGeometry(40, 20), material);
        wall.position.y = 10;
        const box = new three.Mesh(new three.BoxGeometry(1, 1, 1), material);
        box.position.set(-1.2, 0.5, 1.6);
        const sheet = new three.Mesh(new three.PlaneGeometry(3, 2.4), shifted);
        sheet.rotation.x = -Math.PI / 2;
        // beside the box and before the wall, so that it hides neither by its offset
        sheet.position.set(1, 0, 1.4);
        sheet.renderOrder = 1;
        const scene = new three.Scene();
        scene.add(floor, wall, box, new three.AmbientLight(0xffffff, 1));
        const camera = isOrthographic
          ? new three.OrthographicCamera(-4, 4, 3, -3, 0.1, 60)
          : new three.PerspectiveCamera(60, width / height, 0.1, 100);
        camera.position.set(0, isOrthographic ? 4 : 1.4, 5);
        camera.lookAt(0, 0.4, 0);
        camera.updateMatrixWorld();
        const ao = new effects.AmbientOcclusion();
        ao.radius = 1.5;
        return techniquesInTurn(turn, techniques).map((technique) => {
          const open = bench.byTechnique(technique, scene, camera);
          bench.farol.effects = [ao];
          const wanted = bench.byTechnique(technique, scene, camera);
          shifted.polygonOffset = true;
          shifted.polygonOffsetFactor = factor;
          shifted.polygonOffsetUnits = units;
          if (!isWhole && factor + units !== 0) scene.add(sheet);
          const projection = camera.projectionMatrix.clone();
          // the near plane tilted about the camera's axes, as by Lengyel 2005
          if (isOblique) {
            const plane = new three.Vector4(0.2, -0.3, -1, -0.3);
            const corner = new three.Vector4(1, -1, 1, 1).applyMatrix4(camera.projectionMatrixInverse);
            plane.multiplyScalar(2 / plane.dot(corner));
            const { elements } = camera.projectionMatrix;
            [2, 6, 10, 14].forEach((at, i) => (elements[at] = plane.getComponent(i) + (at === 10 ? 1 : 0)));
          }
          if (isOblique) camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
          const image = bench.byTechnique(technique, scene, camera);
          camera.projectionMatrix.copy(projection);
          camera.projectionMatrixInverse.copy(projection).invert();
          shifted.polygonOffset = false;
          scene.remove(sheet);
          bench.farol.effects = [];
          return {
            technique,
            matters: compareImages(wanted, open).psnr,
            psnr: compareImages(wanted, image).psnr,
          };
        });
      },
      { turn, techniques: TECHNIQUES, options },
    );
    test.info().annotations.push({ type: 'agreement', description: JSON.stringify(rows) });
    for (const { technique, psnr, matters } of rows) {
      expect(matters, `${technique}: occlusion is to be seen`).toBeLessThan(30);
      expect
        .soft(psnr, `${technique}: ${psnr.toFixed(1)} dB, ${matters.toFixed(1)} without occlusion`)
        .toBeGreaterThan(55);
    }
  });
}
