import { useCallback, useEffect, useRef, useState } from 'preact/hooks';
import { competitorNames } from '../../competitors/competitorNames';
import type { LabSurroundings } from '../../results/LabRun';
import { surroundingsOf } from '../../results/surroundings';
import { messageOf } from '../../run/messageOf';
import { createStageFrames, type StageFrames } from '../../run/StageFrames';

/** The graphics device and browser that draw. */
export interface Device {
  /** Surroundings of a run that would begin now. */
  readonly surroundings: LabSurroundings;
  /** Whether WebGL has timer queries. */
  readonly timer: boolean;
  readonly software: boolean;
}

export interface StageState {
  /** The device; null while the iframe with `stage.html` loads. */
  readonly device: Device | null;
  /** Reason, a sentence, why nothing can be measured; null if something can. */
  readonly problem: string | null;
  /** Reason, by key, why a competitor cannot draw here; null if it can, undefined while unknown. */
  readonly unavailable: Readonly<Record<string, string | null>>;
  frames(): StageFrames;
  /** Removes the iframes; the next call of `frames` creates new ones. */
  close(): void;
}

/** Creates iframes with `stage.html`; the first one reports the device, and which competitors cannot draw. */
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
    const query = async (): Promise<void> => {
      const stage = await frames().stageOf('forward');
      const found = await stage.device();
      const surroundings = await surroundingsOf(found);
      if (isOver) return;
      setDevice({ surroundings, timer: found.timer, software: found.software });
      const names = Object.keys(competitorNames);
      const reasons = await Promise.all(names.map((name) => stage.unavailable(name).catch(messageOf)));
      if (!isOver) setUnavailable(Object.fromEntries(names.map((name, index) => [name, reasons[index]])));
    };
    // the device is queried after the charts were drawn
    const timer = setTimeout(() => void query().catch((error) => isOver || setProblem(messageOf(error))), 50);
    return () => {
      isOver = true;
      clearTimeout(timer);
      close();
    };
  }, [frames, close]);
  return { device, problem, unavailable, frames, close };
}
