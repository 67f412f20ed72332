import type { Command } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import type { ToolInput } from '@farol/mcp/tools';
import { MathUtils } from 'three';
import type { EditorApi } from '../api/EditorApi';
import type { ArrangedPlace, Arrangement } from '../model/arrange/Arrangement';
import { arrangedPlaces } from '../model/arrange/arrangedPlaces';
import { arrangeObjects } from '../model/arrange/arrangeObjects';
import { topmost } from '../model/commands/Placement';
import { footOf } from '../viewport/placing/DuplicateTool';
import { scatteredPlaces } from '../viewport/placing/scatteredPlaces';
import { SurfaceBelow } from '../viewport/placing/SurfaceBelow';
import { SurfaceSampler } from '../viewport/placing/SurfaceSampler';
import { findObject, findObjects } from './findObjects';

type Input = ToolInput<'duplicate_along'>;

/** Maximum number of objects that a call makes, as in the editor's tool. */
const MOST = 2000;

const arrangementOf = (input: Input): Arrangement => ({
  kind: input.kind,
  count: input.count ?? 5,
  offset: (input.offset ?? [2, 0, 0]) as unknown as Vector3Tuple,
  radius: input.radius ?? 3,
  arc: MathUtils.degToRad(input.arc ?? 360),
  turns: input.turns ?? false,
  counts: (input.counts ?? [5, 1, 5]) as unknown as Vector3Tuple,
  spacing: (input.spacing ?? [2, 2, 2]) as unknown as Vector3Tuple,
  minimumDistance: input.distance ?? 0,
  upwards: true,
  aligns: false,
  randomTurn: false,
  sizeVariation: input.sizeVariation ?? 0,
  follows: input.follows ?? false,
  height: input.height ?? 0,
  seed: input.seed ?? 1,
  colours: input.colours ?? 'same',
  sharesLight: input.sharesLight ?? false,
  intensityVariation: input.intensityVariation ?? 0,
  rangeVariation: 0,
  grouped: input.grouped ?? false,
});

/** Command that copies as the tool “Duplicate along” does. @throws Error for no places, or over `MOST` */
export function duplicateAlong({ document: { scene } }: EditorApi, input: Input): Command {
  const arrangement = arrangementOf(input);
  const sources = topmost(findObjects(scene, input.objects), scene);
  const places = placesOf(arrangement, sources, input);
  if (places.length === 0)
    throw new Error(
      'There is no surface to scatter over: name an object with a mesh as surface, or a smaller distance.',
    );
  if (places.length > MOST) throw new Error(`These are ${places.length} objects: make at most ${MOST} in one call.`);
  return arrangeObjects(scene, sources, places, arrangement);

  function placesOf(settings: Arrangement, objects: readonly GameObject[], { surface }: Input): ArrangedPlace[] {
    scene.three.updateMatrixWorld();
    const feet = objects.map(footOf);
    if (settings.kind === 'scatter') {
      if (surface === undefined) throw new Error('Say which surface: the name of an object with a mesh.');
      return scatteredPlaces(settings, new SurfaceSampler([findObject(scene, surface)], settings.upwards), feet);
    }
    const found = arrangedPlaces(
      settings,
      objects.map(({ transform }) => transform.worldPosition.toArray() as Vector3Tuple),
    );
    if (!settings.follows) return found;
    const below = new SurfaceBelow(scene, new Set(objects));
    return found.map((place) => {
      const [x, y, z] = place.position;
      return { ...place, position: [x, below.heightAt({ x, y, z }) + settings.height + feet[place.source], z] };
    });
  }
}
