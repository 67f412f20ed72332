import { PerspectiveCamera, PointLight, SpotLight } from 'three';
import { describe, expect, it } from 'vitest';
import { FLOATS_PER_RECORD, LIGHT } from '../lights/lightRecord';
import type { LightMasks } from './LightRecords';
import { LightTable } from './LightTable';

const camera = new PerspectiveCamera(60, 1, 0.1, 100);
camera.updateMatrixWorld();
const settings = { shadows: 'all', layers: null } as const;
const size = { width: 64, height: 64 };
/** As while the code that masks a light is not there. */
const without: LightMasks = { records: 0, recordOf: () => -1, write: () => {} };

describe('the light table', () => {
  it.each(['by-volume', 'by-depth', 'by-grid'] as const)(
    'counts by their records which lights are plain (%s)',
    (order) => {
      const point = new PointLight(0xffffff, 1, 5);
      point.castShadow = true;
      const spot = new SpotLight(0xffffff, 1, 5, 0.5);
      for (const light of [point, spot]) {
        light.position.z = -10;
        light.updateMatrixWorld();
      }
      const table = new LightTable();
      table.collect([point, spot], camera, settings);
      table.write(camera, order, size, without);
      const isPlain = Array.from({ length: table.bounded }, (_, k) => {
        const emission = (table.firstBounded + k) * FLOATS_PER_RECORD + LIGHT.emission;
        return table.table.data[emission + 3] >= 0;
      });
      expect(isPlain.filter((plain) => plain)).toHaveLength(1);
      expect(table.others).toBe(1);
    },
  );
});
