import { useEffect, useState } from 'preact/hooks';
import { messageOf } from '../run/messageOf';
import { createStageFrames } from '../run/StageFrames';
import type { NormalsPicture, NormalsWay } from './NormalsPicture';

/** Size of each picture (pixels). */
export const pictureSize = { width: 640, height: 360 } as const;

export interface NormalsPictures {
  readonly pictures: Partial<Readonly<Record<NormalsWay, NormalsPicture>>>;
  /** Reason, a sentence, why there are none. */
  readonly problem: string | null;
}

/**
 * The two pictures of figure 4.3, drawn once in a temporary frame.
 *
 * @param isActive - whether to draw them now: not during a run
 */
export function useNormalsPictures(isActive: boolean): NormalsPictures {
  const [state, setState] = useState<NormalsPictures>({ pictures: {}, problem: null });
  const isDone = state.problem !== null || Boolean(state.pictures.crease);
  useEffect(() => {
    if (!isActive || isDone) return;
    let isOver = false;
    const frames = createStageFrames(document.body);
    const draw = async (): Promise<void> => {
      const stage = await frames.stageOf('deferred');
      for (const way of ['faces', 'crease'] as const) {
        const picture = await stage.drawNormals?.(way, pictureSize);
        if (isOver || !picture) return;
        setState(({ pictures }) => ({ pictures: { ...pictures, [way]: picture }, problem: null }));
      }
    };
    draw()
      .catch((error) => {
        if (!isOver) setState({ pictures: {}, problem: messageOf(error) });
      })
      .finally(() => frames.close());
    return () => {
      isOver = true;
      frames.close();
    };
  }, [isActive, isDone]);
  return state;
}
