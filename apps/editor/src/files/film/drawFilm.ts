import { t } from '@farol/editing';
import { audioOutput, PhysicsSystem, type Scene } from '@farol/engine';
import type { EditorApi } from '../../api/EditorApi';
import { nextTask } from '../picture/nextTask';
import { PictureCanvas } from '../picture/PictureCanvas';
import type { FilmWriter } from './FilmWriter';
import { type FrameRate, framesBetween, timeOf } from './frameRate';
import { makeShot, type ShotName } from './shots';

export interface FilmOptions {
  /** Size of the film (pixels). */
  readonly width: number;
  readonly height: number;
  readonly rate: FrameRate;
  /** Scene time of the film's first frame (s), and the scene time before which its last frame begins (s). */
  readonly from: number;
  readonly to: number;
  /** Whether the scene plays; otherwise only the camera moves. */
  readonly plays: boolean;
  readonly shot: ShotName;
  /** Revolutions of a turntable; negative in the opposite direction. */
  readonly turns: number;
  /** Whether the background is transparent, in place of the scene's. */
  readonly isTransparent: boolean;
}

/** Types of components that are moved by physics. */
const bodies = ['RigidBody', 'Collider', 'CharacterController', 'Joint'];

/** Longest step of a scene (s): physics does not simulate time beyond it. */
const LONGEST_STEP = 0.1;

/** Advances a playing scene, once all code that moves objects is fetched. */
async function advance(scene: Scene, seconds: number): Promise<void> {
  const physics = scene.system(PhysicsSystem);
  if (!physics.ready && bodies.some((type) => scene.componentsOf(type).length > 0)) await physics.prepare();
  if (!scene.assets.isSettled) await scene.assets.settled();
  const steps = Math.ceil(seconds / LONGEST_STEP - 1e-9);
  for (let step = 0; step < steps; step++) scene.update(seconds / steps);
}

/**
 * Draws a film, frame by frame, however long drawing takes: the scene advances by exactly the time between frames. Each
 * frame is drawn as a still, as `PictureCanvas.draw` says. Afterwards the scene is restored, as by Stop.
 * @param writer - receives the frames
 * @param told - called before each frame with its index
 * @param signal - cancels the film
 * @throws AbortError when `signal` is aborted; errors of `makeShot` and of the writer; Error when code cannot be
 *   fetched or the device is lost
 */
export async function drawFilm(
  editor: EditorApi,
  options: FilmOptions,
  writer: FilmWriter,
  told: (frame: number) => void,
  signal: AbortSignal,
): Promise<void> {
  const { document, viewport, preferences } = editor;
  const { scene, simulation, scripts } = document;
  const { width, height, rate, plays } = options;
  const { first, count } = framesBetween(options.from, options.to, rate);
  const step = timeOf(1, rate);
  simulation.stop();
  await scripts.settled();
  await viewport.picture.ready;
  const shot = makeShot(editor, options.shot, width / height, options.turns);
  const canvas = new PictureCanvas(editor, options.isTransparent);
  // sounds play in real time, but the film's frames take longer
  audioOutput.muted = true;
  const goesOn = (): void => {
    signal.throwIfAborted();
    if (document.scene !== scene)
      throw new Error(t('Another scene was opened while the film was made: make it again.'));
  };
  try {
    canvas.setSize(width, height);
    if (plays) simulation.play();
    for (let frame = plays ? 0 : first; frame < first; frame++) {
      await advance(scene, step);
      await nextTask();
      goesOn();
    }
    for (let frame = 0; frame < count; frame++) {
      told(frame);
      if (plays && frame > 0) await advance(scene, step);
      const { eye, component } = shot(frame / count);
      await canvas.drawComplete(eye, component, signal);
      if (frame === 0) canvas.keepTechnique();
      await writer.add();
      await nextTask();
      goesOn();
    }
  } finally {
    if (document.scene === scene) simulation.stop();
    audioOutput.muted = preferences.getState().isMuted;
    canvas.giveBack();
  }
}
