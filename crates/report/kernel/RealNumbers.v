(* Over the real numbers, with the axioms of Coq's reals. *)
From Coq Require Import ZArith QArith Rbase Rbasic_fun Qreals List Lia Lra.
From Boundfit Require Import Reader Checker Convex Sound.
Import ListNotations.
Local Open Scope R_scope.

Definition hullR (points : list (Q * Q)) (p : R * R) :=
  exists a b c, In a points /\ In b points /\ In c points /\
  exists l m n, 0 <= l /\ 0 <= m /\ 0 <= n /\ l + m + n = 1 /\
  fst p = l * Q2R (fst a) + m * Q2R (fst b) + n * Q2R (fst c) /\ snd p = l * Q2R (snd a) + m * Q2R (snd b) + n * Q2R (snd c).
Definition coneR (rays : list (Q * Q)) (p : R * R) :=
  exists a b c, In a rays /\ In b rays /\ In c rays /\
  exists l m n, 0 <= l /\ 0 <= m /\ 0 <= n /\
  fst p = l * Q2R (fst a) + m * Q2R (fst b) + n * Q2R (fst c) /\ snd p = l * Q2R (snd a) + m * Q2R (snd b) + n * Q2R (snd c).
Definition hull_and_coneR (points rays : list (Q * Q)) (p : R * R) :=
  exists v r, hullR points v /\ coneR rays r /\ fst p = fst v + fst r /\ snd p = snd v + snd r.
Definition at_leastR (low : option Q) (value : R) := match low with Some b => Q2R b <= value | None => True end.
Definition at_mostR (value : R) (high : option Q) := match high with Some b => value <= Q2R b | None => True end.
Definition keepsR (c : form) (p : R * R) :=
  at_leastR (low c) (fst p * Q2R (first c) + snd p * Q2R (second c)) /\ at_mostR (fst p * Q2R (first c) + snd p * Q2R (second c)) (high c).

Definition nonnegativeR (a : R) := 0 <= a.
Lemma reals : ordered_field R 0 1 Rplus Rmult Rminus Ropp eq nonnegativeR IZR Q2R.
Proof.
  unfold nonnegativeR. constructor; intros; try reflexivity; try lra.
  - apply eq_equivalence.
  - constructor; repeat intro; now subst.
  - constructor; intros; ring.
  - now apply Rmult_le_pos.
  - apply plus_IZR.
  - apply mult_IZR.
  - apply opp_IZR.
  - now apply IZR_le.
  - exists (/ IZR a). split.
    + apply Rlt_le, Rinv_0_lt_compat, IZR_lt. lia.
    + apply Rinv_r, IZR_neq. lia.
  - unfold Q2R. cbn [Qnum Qden]. field. apply IZR_neq. lia.
Qed.

Definition meets_r := meets R Rplus Rmult Rminus nonnegativeR Q2R.
Definition feasible_r := feasible R Rplus Rmult Rminus nonnegativeR Q2R.
Lemma keepsR_is c p : keepsR c p <-> meets_r c p.
Proof.
  unfold keepsR, meets_r, meets, at_leastR, at_mostR, le, value, nonnegativeR. split.
  - intros [L H]. split; intros b E.
    + rewrite E in L. cbv beta iota in L. lra.
    + rewrite E in H. cbv beta iota in H. lra.
  - intros [L H]. split.
    + destruct (low c) as [b |]; [| exact I]. specialize (L b eq_refl). cbn in *. lra.
    + destruct (high c) as [b |]; [| exact I]. specialize (H b eq_refl). cbn in *. lra.
Qed.
Lemma withinR_is u v y e p : Rabs (Q2R y - (fst p * Q2R u + snd p * Q2R v)) <= Q2R e <-> meets_r (around u v y e) p.
Proof.
  unfold meets_r. rewrite (around_is _ _ _ _ _ _ _ _ _ _ _ reals). unfold le, value, nonnegativeR.
  split.
  - intros H. apply Rabs_def2_le in H || (unfold Rabs in H; destruct (Rcase_abs _) in H); split; lra.
  - intros [L H]. apply Rabs_le. lra.
Qed.
Lemma Q2R_one : Q2R 1 = 1.
Proof. unfold Q2R. cbn. lra. Qed.
Lemma lineR_is x y e p : Rabs (Q2R y - (fst p * Q2R x + snd p)) <= Q2R e <-> meets_r (around x 1 y e) p.
Proof. rewrite <- withinR_is, Q2R_one, Rmult_1_r. reflexivity. Qed.
Lemma togetherR (row : Type) (rows : list row) (says : row -> R * R -> Prop) (of_row : row -> form) conditions p :
  (forall r, says r p <-> meets_r (of_row r) p) ->
  ((forall r, In r rows -> says r p) /\ (forall c, In c conditions -> keepsR c p)) <-> feasible_r (map of_row rows ++ conditions) p.
Proof.
  intros H. unfold feasible_r, feasible. split.
  - intros [R C] c Hc. apply in_app_or in Hc. destruct Hc as [Hc | Hc].
    + apply in_map_iff in Hc. destruct Hc as (r & <- & Hr). apply H. auto.
    + apply keepsR_is. auto.
  - intros F. split.
    + intros r Hr. apply H, F, in_or_app. left. now apply in_map.
    + intros c Hc. apply keepsR_is, F, in_or_app. now right.
Qed.
Lemma betweenR_is u v lo hi p :
  at_leastR lo (fst p * Q2R u + snd p * Q2R v) /\ at_mostR (fst p * Q2R u + snd p * Q2R v) hi <-> meets_r (Form u v lo hi) p.
Proof. exact (keepsR_is (Form u v lo hi) p). Qed.
Lemma line_betweenR_is x lo hi p :
  at_leastR lo (fst p * Q2R x + snd p) /\ at_mostR (fst p * Q2R x + snd p) hi <-> meets_r (Form x 1 lo hi) p.
Proof. rewrite <- betweenR_is, Q2R_one, Rmult_1_r. reflexivity. Qed.
Lemma at_mostR_is u v b p : fst p * Q2R u + snd p * Q2R v <= Q2R b <-> meets_r (Form u v None (Some b)) p.
Proof. rewrite <- betweenR_is. unfold at_leastR, at_mostR. tauto. Qed.
Lemma aloneR (row : Type) (rows : list row) (says : row -> R * R -> Prop) (of_row : row -> form) p :
  (forall r, says r p <-> meets_r (of_row r) p) -> (forall r, In r rows -> says r p) <-> feasible_r (map of_row rows) p.
Proof.
  intros H. unfold feasible_r, feasible. split.
  - intros R c Hc. apply in_map_iff in Hc. destruct Hc as (r & <- & Hr). apply H. auto.
  - intros F r Hr. apply H, F. now apply in_map.
Qed.
Definition set_ofR (vs rs : list (Q * Q)) := match rs with [] => hullR vs | _ => hull_and_coneR vs rs end.
Theorem boundedR forms cert vs : check forms cert vs [] = true -> forall p, feasible_r forms p <-> hullR vs p.
Proof. exact (bounded_sound _ _ _ _ _ _ _ _ _ _ _ reals forms cert vs). Qed.
Theorem unboundedR forms cert vs r rs : check forms cert vs (r :: rs) = true -> forall p, feasible_r forms p <-> hull_and_coneR vs (r :: rs) p.
Proof. exact (unbounded_sound _ _ _ _ _ _ _ _ _ _ _ reals forms cert vs r rs). Qed.
Theorem emptyR forms numbers : check_empty forms numbers = true -> forall p, ~ feasible_r forms p.
Proof. exact (empty_sound _ _ _ _ _ _ _ _ _ _ _ reals forms numbers). Qed.
Theorem set_soundR forms cert vs rs : check forms cert vs rs = true -> forall p, feasible_r forms p <-> set_ofR vs rs p.
Proof. destruct rs; [apply boundedR | apply unboundedR]. Qed.

(* All points at which the objective of a linear program has one value. *)
Lemma level_isR forms a b c v p :
  feasible_r forms p /\ fst p * Q2R a + snd p * Q2R b + Q2R c = Q2R v <-> feasible_r (forms ++ [level a b c v]) p.
Proof.
  assert (D : Q2R (v - c) = Q2R v - Q2R c) by apply Q2R_minus. unfold feasible_r, feasible. split.
  - intros [F E] h H. apply in_app_or in H. destruct H as [H | [<- | []]]; [now apply F |].
    apply betweenR_is. cbn [at_leastR at_mostR]. rewrite D. split; lra.
  - intros F. split; [intros h H; apply F, in_or_app; now left |].
    assert (L : meets_r (level a b c v) p) by (apply F, in_or_app; right; now left).
    apply betweenR_is in L. cbn [at_leastR at_mostR] in L. rewrite D in L. lra.
Qed.
Theorem attainedR forms a b c v cert vs rs : check (forms ++ [level a b c v]) cert vs rs = true ->
  forall p, feasible_r forms p /\ fst p * Q2R a + snd p * Q2R b + Q2R c = Q2R v <-> set_ofR vs rs p.
Proof. intros H p. rewrite level_isR. exact (set_soundR _ cert vs rs H p). Qed.
