import {problemOfStored} from '../../../../web/src/model/documents/design-problem.js';
import {designOf} from '../../../../web/src/model/documents/stored-design.js';
import {MainThreadSolver, SolverClient} from '../../../../web/src/solver/page-solvers.js';
import {leaseSolver} from '../../../../web/src/solver/pool.js';

declare global {
  var Client: typeof SolverClient;
  var InPage: typeof MainThreadSolver;
  var lease: typeof leaseSolver;
  var stored: {
    readonly designOf: typeof designOf;
    readonly problemOfStored: typeof problemOfStored;
  };
}

const stored = {designOf, problemOfStored};
Object.assign(globalThis, {
  ...{Client: SolverClient, InPage: MainThreadSolver, lease: leaseSolver, stored},
});
