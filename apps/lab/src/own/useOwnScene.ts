import { useEffect, useState } from 'preact/hooks';
import { messageOf } from '../run/messageOf';
import type { ReceivedScene } from './receiveScene';

export interface OwnSceneState {
  /** Whether the address asks for a scene that is not there yet. */
  readonly isComing: boolean;
  /** The scene that the editor or the viewer handed over; null for none. */
  readonly scene: ReceivedScene | null;
  /** Why it did not come, as a sentence; empty where nothing went wrong. */
  readonly problem: string;
}

/** Whether the address asks for a scene. */
const isAsked = (): boolean => new URLSearchParams(location.search).has('from');

/** The scene that another app handed over, as the address asks for one; the page's title names it. */
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
