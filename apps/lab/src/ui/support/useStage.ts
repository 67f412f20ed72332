import { useCallback, useEffect, useRef, useState } from 'preact/hooks';
import { competitorNames } from '../../competitors/competitorNames';
import { createStageFrames, type StageFrames } from '../../run/StageFrames';
import { browserName, deviceName } from './browserName';

/** The machine that the figures will be about. */
export interface Device {
  /** Graphics device, short for reading. */
  readonly name: string;
  /** As WebGL names it. */
  readonly renderer: string;
  readonly browser: string;
  readonly system: string;
  /** Whether WebGL tells GPU times. */
  readonly timer: boolean;
  readonly software: boolean;
  /** Why there is no WebGPU, or null when there is. */
  readonly webgpu: string | null;
}

export interface StageState {
  /** Null until the frame has loaded. */
  readonly device: Device | null;
  /** Why nothing can be measured, as a sentence. */
  readonly problem: string | null;
  /** Why competitors cannot draw here, by key; null for those that can; those not asked yet are missing. */
  readonly unavailable: Readonly<Record<string, string | null>>;
  /** Frames to measure in; the caller closes them with `close`. */
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
      const { renderer, timer, software, webgpu } = await stage.device();
      if (isOver) return;
      const { browser, system } = browserName(navigator.userAgent);
      setDevice({ name: deviceName(renderer), renderer, browser, system, timer, software, webgpu });
      for (const name of Object.keys(competitorNames)) {
        const why = await stage.unavailable(name).catch(messageOf);
        if (isOver) return;
        setUnavailable((now) => ({ ...now, [name]: why }));
      }
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

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
