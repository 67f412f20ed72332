import { useCallback, useEffect, useRef, useState } from 'preact/hooks';
import { competitorNames } from '../../competitors/competitorNames';
import type { LabSurroundings } from '../../results/LabRun';
import { surroundingsOf } from '../../results/surroundings';
import { messageOf } from '../../run/messageOf';
import { createStageFrames, type StageFrames } from '../../run/StageFrames';

/** The machine that the figures will be about. */
export interface Device {
  /** Where a run that began now would be made. */
  readonly surroundings: LabSurroundings;
  /** Whether WebGL tells GPU times. */
  readonly timer: boolean;
  readonly software: boolean;
}

export interface StageState {
  /** Null until the frame has loaded. */
  readonly device: Device | null;
  /** Why nothing can be measured, as a sentence. */
  readonly problem: string | null;
  /** Why competitors cannot draw here, by key; null for those that can; those not asked yet are missing. */
  readonly unavailable: Readonly<Record<string, string | null>>;
  /** Frames to measure in. */
  frames(): StageFrames;
  /** Takes the frames away with all they hold; the next call of `frames` makes others. */
  close(): void;
}

/** The frames of `stage.html`, and what the first of them says of the machine and of the competitors. */
export function useStage(): StageState {
  const made = useRef<StageFrames | null>(null);
  const [device, setDevice] = useState<Device | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const [unavailable, setUnavailable] = useState<Record<string, string | null>>({});
  const frames = useCallback(() => (made.current ??= createStageFrames(document.body)), []);
  const close = useCallback(() => {
    made.current?.close();
    made.current = null;
  }, []);

  useEffect(() => {
    let isOver = false;
    const look = async (): Promise<void> => {
      const stage = await frames().stageOf('forward');
      const told = await stage.device();
      const surroundings = await surroundingsOf(told);
      if (isOver) return;
      setDevice({ surroundings, timer: told.timer, software: told.software });
      const names = Object.keys(competitorNames);
      const whys = await Promise.all(names.map((name) => stage.unavailable(name).catch(messageOf)));
      if (!isOver) setUnavailable(Object.fromEntries(names.map((name, index) => [name, whys[index]])));
    };
    // the charts first
    const timer = setTimeout(() => void look().catch((error) => isOver || setProblem(messageOf(error))), 50);
    return () => {
      isOver = true;
      clearTimeout(timer);
      close();
    };
  }, [frames, close]);
  return { device, problem, unavailable, frames, close };
}
