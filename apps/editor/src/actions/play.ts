import type { Camera } from '@farol/engine';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { isEvenlyScaled } from '../model/isEvenlyScaled';
import { isTouchScreen } from '../viewport/isTouchScreen';

const mainCamera = ({ document }: EditorApi): Camera | null => document.scene.activeCamera as Camera | null;

const canPlayThrough = (editor: EditorApi): boolean =>
  editor.document.simulation.state === 'stopped' && mainCamera(editor) !== null;

export const play: Action = {
  id: 'play.play',
  label: 'Play',
  keys: ['Ctrl+P'],
  inFields: true,
  icon: 'play',
  run(editor) {
    const { simulation } = editor.document;
    if (simulation.isPlaying) simulation.stop();
    // on a touch screen dragging then moves the scene's character, not the editor's camera
    else if (isTouchScreen() && canPlayThrough(editor)) editor.viewport.playThrough(mainCamera(editor)!, false);
    else simulation.play();
  },
  checked: ({ document }) => document.simulation.isPlaying,
};

export const pause: Action = {
  id: 'play.pause',
  label: 'Pause',
  keys: ['Ctrl+Shift+P'],
  inFields: true,
  icon: 'pause',
  run({ document: { simulation } }) {
    if (simulation.isPlaying) simulation.pause();
    else simulation.play();
  },
  checked: ({ document }) => document.simulation.state === 'paused',
  enabled: ({ document }) => document.simulation.state !== 'stopped',
};

export const step: Action = {
  id: 'play.step',
  label: 'Step by 1/60 s',
  keys: ['Ctrl+Alt+P'],
  inFields: true,
  icon: 'step',
  run: ({ document }) => document.simulation.step(),
};

export const stop: Action = {
  id: 'play.stop',
  label: 'Stop, and put everything back',
  icon: 'stop',
  run: ({ document }) => document.simulation.stop(),
  enabled: ({ document }) => document.simulation.state !== 'stopped',
};

/** Plays, looking through the scene's camera. */
export const playFromCamera: Action = {
  id: 'play.fromCamera',
  label: 'Play from the camera',
  keys: ['Alt+P'],
  inFields: true,
  icon: 'camera',
  run: (editor) => editor.viewport.playThrough(mainCamera(editor)!, false),
  enabled: canPlayThrough,
};

/** Plays, with the scene's camera moved to the editor's view until the scene stops. */
export const playFromHere: Action = {
  id: 'play.fromHere',
  label: 'Play from here',
  keys: ['Alt+Shift+P'],
  inFields: true,
  icon: 'eye',
  run: (editor) => editor.viewport.playThrough(mainCamera(editor)!, true),
  enabled(editor) {
    const parent = mainCamera(editor)?.gameObject.parent;
    return canPlayThrough(editor) && (!parent || isEvenlyScaled(parent));
  },
};

/** Mutes playing scenes; their sounds keep running. */
export const muteSound: Action = {
  id: 'play.mute',
  label: 'Mute sound',
  icon: 'sound',
  run: ({ preferences }) => preferences.setState(({ isMuted }) => ({ isMuted: !isMuted })),
  checked: ({ preferences }) => preferences.getState().isMuted,
};
