import { clearLearnt, learntChoices } from '@farol/renderer';
import { type Counters, installCounters } from '@farol/tools/benchCounters';
import { loadCompetitor } from '../competitors';
import { smallFirstFrame } from '../competitors/smallFirstFrame';
import { saltShaders } from '../measure/saltShaders';
import { type LabCase, plainCase } from '../plan/LabPlan';
import type { Change, Counts, PassTimes } from '../results/LabRun';
import { isSoftware } from '../words/device';
import { deviceLimits, webglProblem } from './deviceLimits';
import { loseContext } from './loseContext';
import { OpenCompetitor } from './OpenCompetitor';
import type { Opened, Stage, Turn } from './Stage';
import { StageScenes } from './StageScenes';
import { webgpuName } from './webgpuName';

/** The stage in one iframe: the opened competitors, each with a canvas outside of the document. */
export class LabStage implements Stage {
  private readonly scenes = new StageScenes();
  private readonly competitors = new Map<string, OpenCompetitor>();
  private readonly counters: Counters;
  private isWarm = false;

  constructor() {
    installCounters();
    this.counters = (window as unknown as { farolCounters: Counters }).farolCounters;
  }

  async open(
    name: string,
    given: LabCase,
    { signal, longestFrame }: { signal: AbortSignal; longestFrame: number },
  ): Promise<Opened> {
    // the page of an older build, in a comparison of builds, does not send the kind of lights
    const labCase = { ...plainCase, ...given };
    this.close(name);
    const competitor = await loadCompetitor(name);
    const problem = await competitor.unavailable();
    if (problem !== null) throw new Error(problem);
    signal.throwIfAborted();
    if (!this.isWarm) {
      // otherwise the first competitor's time would include the browser's first compilation and cold code
      if (webglProblem() === null) smallFirstFrame(1);
      this.isWarm = true;
    }
    const scene = await this.scenes.build(labCase);
    const canvas = document.createElement('canvas');
    let opened: OpenCompetitor | null = null;
    try {
      const all = [...scene.lights, ...scene.still];
      const refused = competitor.refuses({
        lights: all.length,
        shadows: all.filter(({ castShadow }) => castShadow).length,
        kind: scene.kind,
        shading: scene.shading,
      });
      if (refused !== null) throw new Error(refused);
      signal.throwIfAborted();
      Object.assign(canvas, { width: labCase.width, height: labCase.height });
      saltShaders(canvas);
      const drawing = await competitor.open(canvas, scene, signal, longestFrame);
      opened = new OpenCompetitor(competitor, canvas, scene, drawing, this.counters);
      const result = await opened.drawFirst(signal);
      this.competitors.set(name, opened);
      return result;
    } catch (error) {
      if (opened) opened.close();
      else {
        scene.dispose();
        const gl = canvas.getContext('webgl2');
        if (gl) loseContext(gl);
      }
      throw error;
    }
  }

  async turn(name: string, ms: number): Promise<Turn> {
    return this.get(name).turn(ms);
  }

  async count(name: string): Promise<Counts> {
    return this.get(name).count();
  }

  async passes(name: string): Promise<PassTimes | null> {
    return this.get(name).passes();
  }

  async addLights(name: string): Promise<Change> {
    return this.get(name).addLights();
  }

  async changeTechnique(name: string): Promise<Change | null> {
    return this.get(name).changeTechnique();
  }

  close(name: string): void {
    const open = this.competitors.get(name);
    this.competitors.delete(name);
    open?.close();
  }

  async unavailable(name: string): Promise<string | null> {
    return (await loadCompetitor(name)).unavailable();
  }

  async setOwnScene(file: Uint8Array): Promise<void> {
    this.scenes.setOwn(file);
  }

  async device(): ReturnType<Stage['device']> {
    const { renderer, timer } = deviceLimits();
    const software = isSoftware(renderer);
    return { renderer, timer: timer && !software, software, webgpu: await webgpuName() };
  }

  async learn(labCase: LabCase, signal: AbortSignal, onShare: (share: number) => void): Promise<void> {
    const { learnCase } = await import('./learnCase');
    await learnCase(await this.scenes.build(labCase), signal, onShare);
  }

  learnt = learntChoices;
  clearLearnt = clearLearnt;

  private get(name: string): OpenCompetitor {
    const open = this.competitors.get(name);
    if (!open) throw new Error(`The competitor ‘${name}’ is not open: open it for a case first.`);
    return open;
  }
}
