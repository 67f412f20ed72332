import { useEffect, useState } from 'preact/hooks';
import { messageOf } from '../run/messageOf';
import type { ReceivedScene } from './receiveScene';

export interface OwnSceneState {
  /** Whether a scene is expected and has not arrived yet. */
  readonly isComing: boolean;
  /** The scene handed over by the editor or the viewer; null for none. */
  readonly scene: ReceivedScene | null;
  /** Reason, a sentence, why the scene did not arrive; empty for no problem. */
  readonly problem: string;
}

/** Whether the address names a page that hands over a scene. */
const isAsked = (): boolean => new URLSearchParams(location.search).has('from');

/** The scene handed over by another app, if the address names one; sets the page's title to its name. */
export function useOwnScene(): OwnSceneState {
  const [state, setState] = useState<OwnSceneState>(() => ({
    isComing: isAsked(),
    scene: null,
    problem: '',
  }));
  useEffect(() => {
    if (!isAsked()) return;
    let isOver = false;
    const receive = import('./receiveScene').then(({ receiveScene }) => receiveScene());
    receive.then(
      (scene) => {
        if (isOver) return;
        if (scene) document.title = `${scene.name} · Farol Lab`;
        setState({ isComing: false, scene, problem: '' });
      },
      (error: unknown) => {
        const problem = messageOf(error);
        if (!isOver) setState({ isComing: false, scene: null, problem });
      },
    );
    return () => {
      isOver = true;
    };
  }, []);
  return state;
}
