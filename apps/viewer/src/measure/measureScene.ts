import type { Scene } from '@farol/engine';
import { openBeside } from '@farol/engine/files';
import { scenes } from '@farol/scenes';
import type { LoadedModel } from '../model/loadModel';
import type { ViewerState } from '../state/ViewerState';
import { labFragment, ownSceneFragment } from './labFragment';

/**
 * Opens the Lab with the current scene: by address if the Lab can build the scene, otherwise as a file.
 *
 * @param model - the dropped model; null for a scene of the engine
 * @throws Error (as a rejection) that says what to do, see `openBeside`
 */
export function measureScene(
  scene: Scene,
  model: LoadedModel | null,
  state: Pick<ViewerState, 'scene' | 'parameters'>,
): Promise<void> {
  const definition = scenes[state.scene];
  const fragment = model ? null : labFragment(state.scene, state.parameters, definition?.parameters ?? {});
  if (fragment !== null) return openBeside('lab', 'the Lab', { fragment });
  const bytes = async (): Promise<Uint8Array<ArrayBuffer>> => {
    const { sceneFile } = await import('./sceneFile');
    return sceneFile(scene, model);
  };
  const name = model?.name ?? definition?.label ?? state.scene;
  return openBeside('lab', 'the Lab', { fragment: ownSceneFragment, scene: { name, bytes } });
}
