import { CommandStack } from '@farol/editing';
import { Camera, GameObject, Scene } from '@farol/engine';
import { createRandom } from '@farol/engine/scenes';
import { Quaternion, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { addCameraAt, alignCamera, type CameraView, isEvenlyScaled, poseProblem } from './cameraEdits';
