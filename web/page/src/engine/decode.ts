/** What the engine hands out, as plain objects and typed arrays. */
import type { StudySum as WasmStudy, TrackRun as WasmRun } from "../wasm/track/rangelab_track.js";
import type { BoundRun, EstimatorRun, Run } from "../run";
import type { BoundCurves, Curve, EstimatorCurves, StudyCurves } from "../study";

interface Named {
  name: string;
  label: string;
}

export function decodeRun(run: WasmRun): Run {
  const dimension = run.dimension();
  const estimators: Named[] = JSON.parse(run.estimators());
  const bounds: Named[] = JSON.parse(run.bounds());
  return {
    dimension,
    steps: run.steps(),
    times: run.times(),
    anchors: rows(run.anchors(), dimension),
    geometry: JSON.parse(run.geometry()),
    present: run.present(),
    truth: { orientations: run.truth_orientations(), positions: run.truth_positions() },
    estimators: estimators.map((entry, index) => decodeEstimator(run, entry, index)),
    bounds: bounds.map((entry, index) => decodeBound(run, entry, index)),
  };
}

function decodeEstimator(run: WasmRun, entry: Named, index: number): EstimatorRun {
  const step = run.failed_at(index);
  return {
    ...entry,
    orientations: run.orientations(index),
    positions: run.positions(index),
    orientationErrors: run.orientation_errors(index),
    positionErrors: run.position_errors(index),
    defects: run.defects(index),
    events: run.events(index),
    nees: run.nees(index),
    neesDegreesOfFreedom: run.nees_degrees_of_freedom(index),
    nis: run.nis(index),
    nisDegreesOfFreedom: run.nis_degrees_of_freedom(index),
    positionCovariances: run.position_covariances(index),
    rotationCovariances: run.rotation_covariances(index),
    stopped: step < 0 ? null : { step, sentence: run.failure(index) },
  };
}

function decodeBound(run: WasmRun, entry: Named, index: number): BoundRun {
  return {
    ...entry,
    orientation: run.orientation_bounds(index),
    position: run.position_bounds(index),
    positionCovariances: run.position_bound_covariances(index),
    rotationCovariances: run.rotation_bound_covariances(index),
  };
}

export function decodeStudy(study: WasmStudy): StudyCurves {
  const estimators: Named[] = JSON.parse(study.estimators());
  const bounds: Named[] = JSON.parse(study.bounds());
  return {
    trials: study.trials(),
    estimators: estimators.map((entry, index) => decodeCurves(study, entry, index)),
    bounds: bounds.map((entry, index) => decodeBoundCurves(study, entry, index)),
  };
}

function decodeCurves(study: WasmStudy, entry: Named, index: number): EstimatorCurves {
  return {
    ...entry,
    angle: curve(study.angle(index)),
    position: curve(study.position(index)),
    nees: curve(study.nees(index)),
    neesDegreesOfFreedom: study.nees_degrees_of_freedom(index),
    nis: curve(study.nis(index)),
    nisDegreesOfFreedom: study.nis_degrees_of_freedom(index),
    eventRate: curve(study.event_rate(index)),
    failures: study.failures(index),
  };
}

function decodeBoundCurves(study: WasmStudy, entry: Named, index: number): BoundCurves {
  return { ...entry, angle: curve(study.angle_bound(index)), position: curve(study.position_bound(index)) };
}

/** The engine writes values, then standard errors. */
export function curve(numbers: Float64Array): Curve {
  const steps = numbers.length / 2;
  return { value: numbers.subarray(0, steps), standardError: numbers.subarray(steps) };
}

export function rows(values: Float64Array, width: number): number[][] {
  return Array.from({ length: values.length / width }, (_, row) => [
    ...values.subarray(row * width, (row + 1) * width),
  ]);
}
